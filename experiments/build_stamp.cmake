# Runs at every build; configure_file leaves the header alone when nothing changed, so that only a
# new commit or a new state of the tree recompiles provenance.cpp.
# Given by -D: SOURCE_DIR, TEMPLATE, HEADER, VERSION, COMPILER, FLAGS, BUILD_TYPE.
function(git result)
  execute_process(COMMAND git -C "${SOURCE_DIR}" ${ARGN} OUTPUT_VARIABLE output ERROR_QUIET
    OUTPUT_STRIP_TRAILING_WHITESPACE RESULT_VARIABLE status)
  set(${result} "${output}" PARENT_SCOPE)
  set(${result}_STATUS "${status}" PARENT_SCOPE)
endfunction()

git(COMMIT rev-parse --verify HEAD)
if(NOT COMMIT_STATUS STREQUAL "0")
  set(COMMIT unknown)
endif()
git(CHANGES status --porcelain)
if(CHANGES)
  set(DIRTY true)
else()
  set(DIRTY false)
endif()
string(STRIP "${FLAGS}" FLAGS)
configure_file("${TEMPLATE}" "${HEADER}" @ONLY)
