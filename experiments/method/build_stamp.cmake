# Runs at every build; configure_file leaves the header alone when nothing changed, so that only a
# new commit or a new state of the tree recompiles provenance.cpp.
# Given by -D: SOURCE_DIR, TEMPLATE, HEADER, VERSION, COMPILER, FLAGS, BUILD_TYPE.
function(git result)
  execute_process(COMMAND git -C "${SOURCE_DIR}" ${ARGN} OUTPUT_VARIABLE output ERROR_QUIET
    OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(${result} "${output}" PARENT_SCOPE)
endfunction()

# Only what makes the program counts: a commit to a document or to the analysis leaves it, and
# with it the results of a study half done, as they are.
set(program -- CMakeLists.txt ldm baselines datasets experiments ":(exclude)*.py" ":(exclude)*.md")
git(COMMIT log -1 --format=%H ${program})
if(NOT COMMIT)
  set(COMMIT unknown)
endif()
git(CHANGES status --porcelain ${program})
if(CHANGES)
  set(DIRTY true)
else()
  set(DIRTY false)
endif()
string(STRIP "${FLAGS}" FLAGS)
configure_file("${TEMPLATE}" "${HEADER}" @ONLY)
