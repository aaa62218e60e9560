# The installed tree alone: a consumer builds and runs against it, and so does the plugin of docs/variants.md.
set(prefix ${CMAKE_CURRENT_BINARY_DIR}/installed)

add_test(NAME installed.clean COMMAND ${CMAKE_COMMAND} -E rm -rf ${prefix})
add_test(NAME installed.install COMMAND ${CMAKE_COMMAND} --install ${PROJECT_BINARY_DIR} --prefix ${prefix})
set_tests_properties(installed.clean PROPERTIES FIXTURES_SETUP clean_prefix)
set_tests_properties(installed.install PROPERTIES FIXTURES_REQUIRED clean_prefix FIXTURES_SETUP prefix)

# add_installed_test(NAME SOURCES COMMAND...): builds the project against the tree, then runs the command.
function(add_installed_test name sources)
  add_test(NAME installed.${name} COMMAND ${CMAKE_CTEST_COMMAND}
    --build-and-test ${sources} ${CMAKE_CURRENT_BINARY_DIR}/${name}
    --build-generator ${CMAKE_GENERATOR}
    --build-options -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}
      -DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}
      "-DCMAKE_CXX_FLAGS=-Wall -Wextra -Werror" -Dldm_ROOT=${prefix}
    --test-command ${ARGN})
  set_tests_properties(installed.${name} PROPERTIES FIXTURES_REQUIRED prefix)
endfunction()

add_installed_test(consumer ${CMAKE_CURRENT_SOURCE_DIR}/consumer ${CMAKE_CURRENT_BINARY_DIR}/consumer/consumer)
set_tests_properties(installed.consumer PROPERTIES
  PASS_REGULAR_EXPRESSION "ldm ${PROJECT_VERSION}\n6 voxels at 2.25 +0.5 +0.25\n")
add_installed_test(plugin ${PROJECT_SOURCE_DIR}/docs/variants
  ${prefix}/bin/ldm run fading_buffer scenario1 --plugin ${CMAKE_CURRENT_BINARY_DIR}/plugin/fading_buffer.so
  --frames 3 -o ${CMAKE_CURRENT_BINARY_DIR}/plugin/out)
