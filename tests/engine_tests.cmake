# The tests of the run: its parts, and the program as a user calls it.
stream_recon_test(engine_test PARALLEL
  SOURCES engine_budget_test.cpp engine_order_test.cpp engine_progress_test.cpp
    engine_report_test.cpp engine_surface_test.cpp
  LIBRARIES stream_recon::engine GTest::gmock)
