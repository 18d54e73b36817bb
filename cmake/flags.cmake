# SPDX-License-Identifier: Apache-2.0
# SPDX-FileCopyrightText: The quadcut developers
# Flags every target of ours gets; an interface library keeps them away from whoever embeds us.
add_library(quadcut_flags INTERFACE)
target_compile_options(quadcut_flags INTERFACE $<$<COMPILE_LANGUAGE:CXX>:
    -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Wno-sign-conversion
    $<$<BOOL:${QUADCUT_WERROR}>:-Werror>
    # What these say follows from how far g++ 12 has optimized, and is often not so: overlapping
    # copies in std::string operator+ (GCC bug 105329), writes past the end of a vector just sized.
    $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-error=array-bounds -Wno-error=maybe-uninitialized
        -Wno-error=stringop-overflow -Wno-error=stringop-overread>
    # Same input, same bytes: a fused multiply-add rounds once where two operations round twice.
    -ffp-contract=off
    # Nobody asks for errno or for floating-point exceptions: square roots need no call, and loops
    # with them are done several numbers at a time. Results stay the same.
    -fno-math-errno -fno-trapping-math
    # Nobody replaces our functions at run time: they are inlined in a shared library, too.
    -fno-semantic-interposition>)
if(QUADCUT_SANITIZE OR QUADCUT_FUZZ)
    add_compile_definitions(_GLIBCXX_ASSERTIONS)
endif()
if(QUADCUT_SANITIZE)
    add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fsanitize=${QUADCUT_SANITIZE}>
        $<$<COMPILE_LANGUAGE:CXX>:-fno-sanitize-recover=all>
        $<$<COMPILE_LANGUAGE:CXX>:-fno-omit-frame-pointer>)
    add_link_options(-fsanitize=${QUADCUT_SANITIZE})
endif()
if(QUADCUT_FUZZ)
    if(NOT CMAKE_CXX_COMPILER_ID MATCHES Clang)
        message(FATAL_ERROR "QUADCUT_FUZZ needs clang: cmake --preset fuzz")
    endif()
    add_compile_options($<$<COMPILE_LANGUAGE:CXX>:-fsanitize=fuzzer-no-link>)
endif()
