# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
# cmake -D SOURCE=... -D OUTPUT=... -P commit.cmake: writes OUTPUT, which names the commit. It is run
# by each build and touches the file only when the commit is another, so that one file is compiled.
# "unknown" without git, or when SOURCE is no repository of its own (an archive of the sources).
set(commit unknown)
if(EXISTS ${SOURCE}/.git)
    execute_process(COMMAND git describe --always WORKING_DIRECTORY ${SOURCE}
        RESULT_VARIABLE failed OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(failed EQUAL 0)
        set(commit ${described})
        # As ./run bench says it: documents change nothing that is measured.
        execute_process(COMMAND git status --porcelain -- . ":!docs" ":!*.md"
            WORKING_DIRECTORY ${SOURCE} OUTPUT_VARIABLE changes ERROR_QUIET)
        if(changes)
            string(APPEND commit -dirty)
        endif()
    endif()
endif()
configure_file(${CMAKE_CURRENT_LIST_DIR}/../src/reproduce/commit.cpp.in ${OUTPUT} @ONLY)
