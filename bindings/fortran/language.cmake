# Turns Fortran on if there is a compiler for it; to be included in every folder that holds Fortran targets.
include(CheckLanguage)
check_language(Fortran)
if(CMAKE_Fortran_COMPILER)
  enable_language(Fortran)
endif()
