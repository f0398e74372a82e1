# Writes a source file that knows the commit of a source tree, and leaves it alone if it says so already: run at every
# build, so that nothing else is compiled again when the commit changes.
#   cmake -DSOURCE=TREE -DTEMPLATE=FILE -DOUTPUT=FILE -DCOMMIT=auto|TEXT [-DGIT=PROGRAM] -P commit.cmake
# COMMIT `auto` asks git; none is known without git, without a repository, as in a tarball, and where the tree is
# only a folder of another repository. The hash is cut here, as its abbreviation depends on what else a clone holds.
cmake_minimum_required(VERSION 3.25)

# What git says, without its line end; nothing where it fails.
function(git result)
  execute_process(COMMAND ${GIT} --no-optional-locks -C ${SOURCE} ${ARGN} OUTPUT_VARIABLE said ERROR_QUIET
    RESULT_VARIABLE status OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT status EQUAL 0)
    set(said "")
  endif()
  set(${result} "${said}" PARENT_SCOPE)
endfunction()

set(commit "${COMMIT}")
if(COMMIT STREQUAL "auto")
  set(commit "")
  if(GIT)
    git(top rev-parse --show-toplevel)
    git(hash rev-parse --verify HEAD)
    git(changes status --porcelain --untracked-files=no)
  endif()
  file(REAL_PATH "${SOURCE}" source)
  if(hash AND top STREQUAL source)
    string(SUBSTRING "${hash}" 0 7 commit)
    if(changes)
      string(APPEND commit ", changed")
    endif()
  endif()
endif()
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
