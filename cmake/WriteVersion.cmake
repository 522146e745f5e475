# cmake -DSOURCE=... -DVERSION=... -DCOMMIT=... -DOUTPUT=... -P WriteVersion.cmake: the source of playhouse/base/version.h.
# Every build runs it; the file is written only when its content changes, so a build without a new commit compiles nothing.
# COMMIT is for trees that are no repository, as from an archive; one that lies in somebody else's is not asked. The archive of
# `make source` has a file that names its commit.

if(EXISTS ${SOURCE}/.git)
  execute_process(COMMAND git --no-optional-locks -C ${SOURCE} describe --always --abbrev=7 --dirty --exclude=*
    OUTPUT_VARIABLE FOUND OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE FAILED)
  if(FAILED EQUAL 0)
    set(COMMIT ${FOUND})
  endif()
endif()
if(NOT COMMIT AND EXISTS ${SOURCE}/COMMIT)
  file(STRINGS ${SOURCE}/COMMIT COMMIT LIMIT_COUNT 1)
endif()
if(NOT COMMIT)
  set(COMMIT unknown)
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/version.cc.in ${OUTPUT} @ONLY)
