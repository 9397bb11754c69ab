# Several sources of a folder compiled as one unit: most of a compilation, and nearly all of clang-tidy's time, goes into headers
# (Eigen, the standard library, VTK), which a unit reads once. Names in anonymous namespaces are therefore one to a folder.
option(HFRAC_UNITY "Compile several sources of a folder as one unit" ON)
set(HFRAC_UNITY_SIZE 8)  # sources in a unit

if(HFRAC_UNITY)
  add_compile_options($<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-subobject-linkage>)  # meant for headers, told of every source but a unit's own
endif()

# To be called when all of a target's sources are named. Sources with compile options of their own stay alone: CMake leaves them out.
function(unite target)
  if(NOT HFRAC_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  foreach(source IN LISTS sources)
    get_filename_component(folder "${source}" DIRECTORY)
    string(MAKE_C_IDENTIFIER "unit_${folder}" group)
    math(EXPR ${group}_count "${${group}_count} + 1")
    math(EXPR part "(${${group}_count} - 1) / ${HFRAC_UNITY_SIZE}")
    set_property(SOURCE ${source} PROPERTY UNITY_GROUP ${group}_${part})
  endforeach()
endfunction()
