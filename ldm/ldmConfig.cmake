include(CMakeFindDependencyMacro)
find_dependency(Eigen3 3.4 NO_MODULE)
find_dependency(TBB)
include(${CMAKE_CURRENT_LIST_DIR}/ldmTargets.cmake)
