# Sets TM_LIBCXX if a native build uses libc++, for example clang++ with
# -DCMAKE_CXX_FLAGS=-stdlib=libc++.
include(CheckCXXSymbolExists)
check_cxx_symbol_exists(_LIBCPP_VERSION version TM_LIBCXX)
if(NOT TM_LIBCXX)
  return()
endif()
# The system's C++ libraries may be built with libstdc++. Only shared libraries load libstdc++
# themselves, so TM_STATIC is switched off. The interfaces between these libraries and this project
# have no types of the standard library.
set(TM_STATIC OFF)
find_path(TM_FAST_FLOAT fast_float/fast_float.h REQUIRED)
mark_as_advanced(TM_FAST_FLOAT)
