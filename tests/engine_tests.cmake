# The tests of the run: its parts, and the program as a user calls it.
stream_recon_test(engine_test PARALLEL
  SOURCES engine_ball_walk_test.cpp engine_budget_test.cpp engine_chunk_loop_test.cpp
    engine_crust_test.cpp engine_disk_test.cpp engine_facet_filter_test.cpp
    engine_far_points_test.cpp engine_faults_test.cpp engine_hybrid_test.cpp
    engine_memory_trace_test.cpp
    engine_order_test.cpp engine_pole_store_test.cpp engine_poles_test.cpp engine_power_test.cpp
    engine_progress_test.cpp engine_report_test.cpp engine_shape_test.cpp engine_sheets_test.cpp
    engine_solid_test.cpp engine_spacing_test.cpp engine_surface_test.cpp
    engine_tetrahedra_test.cpp engine_window_parts_test.cpp engine_windows_test.cpp
  LIBRARIES stream_recon::engine GTest::gmock)

stream_recon_test(engine_labels_forest_test PARALLEL
  SOURCES engine_labels_forest_test.cpp engine_labels_merge_test.cpp
  LIBRARIES stream_recon::engine GTest::gmock)

stream_recon_test(engine_patch_test
  SOURCES engine_hole_rings_test.cpp engine_patch_test.cpp
  LIBRARIES stream_recon::engine)

add_executable(restart_driver restart_driver.cpp)
target_link_libraries(restart_driver PRIVATE stream_recon::engine stream_recon_flags)
target_include_directories(restart_driver PRIVATE ${PROJECT_SOURCE_DIR})
stream_recon_test(engine_restart_test
  SOURCES engine_restart_test.cpp
  LIBRARIES stream_recon::engine GTest::gmock)
add_dependencies(engine_restart_test restart_driver)
target_compile_definitions(engine_restart_test PRIVATE
  STREAM_RECON_RESTART_DRIVER="$<TARGET_FILE:restart_driver>")

if(STREAM_RECON_TOOLS)
  find_package(PNG REQUIRED)
  stream_recon_test(cli_test
    SOURCES cli_check_test.cpp cli_crust_test.cpp cli_errors_test.cpp cli_html_test.cpp
      cli_hybrid_test.cpp
      cli_manifold_test.cpp cli_medial_axis_test.cpp cli_pipe_test.cpp cli_restart_test.cpp
      cli_results_test.cpp cli_solid_test.cpp
      cli_tetrahedra_test.cpp
      cli_unused_test.cpp
    LIBRARIES stream_recon::io GTest::gmock)
  add_dependencies(cli_test stream-recon make-cloud mesh-check)
  target_compile_definitions(cli_test PRIVATE
    STREAM_RECON_BIN="${CMAKE_RUNTIME_OUTPUT_DIRECTORY}"
    STREAM_RECON_VTK_PYTHON="${VTK_PYTHON}" STREAM_RECON_TESTS="${CMAKE_CURRENT_SOURCE_DIR}")
  target_link_libraries(cli_test PRIVATE PNG::PNG)
endif()
