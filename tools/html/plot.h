// The frame of a chart: axes with round numbers, and marks in the units of the data.
//
// Thread rule: one thread.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace stream_recon::html {

struct PlotAxes {
  double x_end = 1;  ///< both axes begin at 0
  double y_end = 1;
  std::function<std::string(double)> x_text;  ///< of a tick
  std::function<std::string(double)> y_text;
  double x_step = 0;  ///< between ticks; 0: some round number
  double y_step = 0;
  std::string title;  ///< for readers who hear the page
};

class Plot {
 public:
  explicit Plot(PlotAxes axes);

  /// A box from one corner to the other, in data units, with further attributes.
  void box(double x0, double y0, double x1, double y1, std::string_view attributes);
  /// Adds a point to the line that is begun; end_area() closes it down to the axis.
  void add_point(double x, double y);
  void end_area();
  /// A level across the plot.
  void level(double y, const std::string& label);
  /// Text in the middle of a stretch of the x axis, at the top; left out where it does not fit.
  void heading(double x0, double x1, const std::string& text);

  /// The whole <svg>.
  std::string svg() const;

 private:
  double px(double x) const;
  double py(double y) const;
  std::string frame() const;

  PlotAxes axes_;
  std::string marks_;
  std::string over_;  ///< what lies above the frame
  std::string path_;
  double first_x_ = 0;
  double last_x_ = 0;
};

/// A round step (1, 2 or 5 times a power of ten) that goes into `end` about `ticks` times.
double round_step(double end, int ticks);

}  // namespace stream_recon::html
