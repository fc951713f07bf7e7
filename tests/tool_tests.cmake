# The tests of the small programs: their libraries, and the programs as a user calls them.
if(NOT STREAM_RECON_TOOLS)
  return()
endif()

stream_recon_test(tool_clouds_test
  SOURCES tool_clouds_test.cpp tool_gyroid_genus_test.cpp tool_known_solid_test.cpp
    tool_solid_samples_test.cpp
  LIBRARIES stream_recon_clouds)
stream_recon_test(tool_solid_quality_test
  SOURCES tool_pole_links_test.cpp tool_solid_quality_test.cpp benchmarks/label_error.cpp
    benchmarks/pole_links.cpp
  LIBRARIES stream_recon_clouds)
stream_recon_test(tool_point_sink_test
  SOURCES tool_point_sink_test.cpp
  LIBRARIES stream_recon_points)
stream_recon_test(tool_sampling_test
  SOURCES tool_iso_scan_test.cpp tool_sampling_test.cpp
  LIBRARIES stream_recon_sampling GTest::gmock)
stream_recon_test(tool_radix_sort_test
  SOURCES tool_radix_sort_test.cpp
  LIBRARIES stream_recon_kernel_bench)
stream_recon_test(tool_preview_test
  SOURCES tool_depth_buffer_test.cpp tool_preview_color_test.cpp tool_preview_formats_test.cpp
    tool_preview_reference_test.cpp tool_preview_scene_test.cpp tool_preview_test.cpp
  LIBRARIES stream_recon_preview)
find_package(PNG REQUIRED)
target_link_libraries(tool_preview_test PRIVATE PNG::PNG)
target_compile_definitions(tool_preview_test PRIVATE
  STREAM_RECON_PICTURES="${CMAKE_CURRENT_SOURCE_DIR}/pictures"
  STREAM_RECON_BIN="${CMAKE_RUNTIME_OUTPUT_DIRECTORY}")
add_dependencies(tool_preview_test mesh-preview make-cloud stream-recon)
stream_recon_test(tool_html_test
  SOURCES tool_html_test.cpp
  LIBRARIES stream_recon_html GTest::gmock)

stream_recon_test(tool_check_test PARALLEL
  SOURCES tool_check_test.cpp
  LIBRARIES stream_recon_check)

stream_recon_test(tool_programs_test
  SOURCES tool_programs_test.cpp
  LIBRARIES stream_recon::io)
add_dependencies(tool_programs_test make-cloud bench-kernel mesh-preview)
target_compile_definitions(tool_programs_test PRIVATE
  STREAM_RECON_BIN="${CMAKE_RUNTIME_OUTPUT_DIRECTORY}")

if(STREAM_RECON_CONVERTERS)
  add_dependencies(tool_programs_test slices-to-points)
  target_compile_definitions(tool_programs_test PRIVATE STREAM_RECON_HAS_CONVERTERS)
  stream_recon_test(tool_converter_test
    SOURCES tool_converter_test.cpp
    LIBRARIES stream_recon::io GTest::gmock)
  add_dependencies(tool_converter_test slices-to-points stream-recon)
  target_compile_definitions(tool_converter_test PRIVATE
    STREAM_RECON_BIN="${CMAKE_RUNTIME_OUTPUT_DIRECTORY}")
  find_package(ZLIB REQUIRED)
  target_link_libraries(tool_converter_test PRIVATE ZLIB::ZLIB)
  stream_recon_test(tool_slices_test
    SOURCES tool_dicom_test.cpp tool_image_stack_test.cpp tool_raw_volume_test.cpp
      tool_shared_volumes_test.cpp tool_slices_memory_test.cpp tool_volume_file_test.cpp
    LIBRARIES stream_recon_slices stream_recon_sampling)
  find_package(JPEG REQUIRED)
  find_package(TIFF REQUIRED)
  target_link_libraries(tool_slices_test PRIVATE JPEG::JPEG PNG::PNG TIFF::TIFF ZLIB::ZLIB)

  # The commands of the cookbook, a test for each recipe.
  set(cookbook ${CMAKE_CURRENT_SOURCE_DIR}/cookbook.py)
  set(recipes_of ${PROJECT_SOURCE_DIR}/docs/cookbook.md)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${recipes_of})
  execute_process(COMMAND ${Python3_EXECUTABLE} ${cookbook} --list ${recipes_of}
    OUTPUT_VARIABLE recipes OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE "\n" ";" recipes "${recipes}")
  foreach(recipe ${recipes})
    add_test(NAME "cookbook: ${recipe}" COMMAND Python3::Interpreter ${cookbook} ${recipes_of}
      ${recipe} ${CMAKE_RUNTIME_OUTPUT_DIRECTORY} ${PROJECT_SOURCE_DIR}/../shared/data)
    set_tests_properties("cookbook: ${recipe}" PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 600)
  endforeach()
  add_test(NAME cookbook_check_can_fail COMMAND Python3::Interpreter ${cookbook} --self-check)
endif()
