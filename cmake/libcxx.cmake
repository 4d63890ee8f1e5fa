# Native builds with libc++, as by -DCMAKE_CXX_FLAGS=-stdlib=libc++ with clang++. Sets TM_LIBCXX.
include(CheckCXXSymbolExists)
check_cxx_symbol_exists(_LIBCPP_VERSION version TM_LIBCXX)
if(NOT TM_LIBCXX)
  return()
endif()
# The system's C++ libraries may be built with libstdc++, which only shared ones bring with them. What
# passes between them and this project are no types of the standard library.
set(TM_STATIC OFF)
find_path(TM_FAST_FLOAT fast_float/fast_float.h REQUIRED)
mark_as_advanced(TM_FAST_FLOAT)
