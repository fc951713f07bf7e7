#include "io/pvtp_writer.h"

#include <atomic>
#include <cstdint>
#include <string>

#include "io/chunked_output.h"
#include "io/file.h"
#include "io/vtk_xml_mesh.h"
#include "io/vtp_writer.h"

namespace stream_recon {
namespace {

std::string cell_data(bool has_closure) {
  std::string text =
      "<PCellData Scalars=\"Delta\">\n"
      "<PDataArray type=\"Float32\" Name=\"Delta\"/>\n"
      "<PDataArray type=\"UInt8\" Name=\"Source\"/>\n";
  if (has_closure) text += "<PDataArray type=\"Float32\" Name=\"Closure\"/>\n";
  return text + "</PCellData>\n";
}

class PvtpWriter final : public SurfaceWriter {
 public:
  explicit PvtpWriter(const SurfaceWriterOptions& options)
      : options_({.coordinates = options.coordinates,
                  .has_closure = options.has_closure,
                  .has_sheets = options.has_sheets}),
        output_({.index = options.path, .index_ending = ".pvtp", .chunk_ending = ".vtp"}) {}

  bool takes_chunks_in_order() const override { return false; }

  void write(std::uint64_t number, const SurfaceChunk& chunk) override {
    File file = output_.create_chunk(number);
    VtpWriter(options_).write(chunk, file);
    bytes_written_ += file.position();
    file.close();
  }

  std::uint64_t bytes_written() const override { return bytes_written_; }

 private:
  void complete() override {
    if (bytes_written_ == 0) write(0, {});  // readers expect a piece, even an empty one
    const std::string text = index_text({.type = "PolyData",
                                         .cell_data = cell_data(options_.has_closure),
                                         .scalar = options_.coordinates,
                                         .has_sheets = options_.has_sheets,
                                         .pieces = output_.chunk_paths()});
    output_.prepare(text);
    bytes_written_ += text.size();
  }

  void publish() override {
    output_.publish();
    output_.keep();
  }

  VtpWriterOptions options_;
  ChunkedOutput output_;
  std::atomic<std::uint64_t> bytes_written_ = 0;
};

}  // namespace

std::unique_ptr<SurfaceWriter> make_pvtp_writer(const SurfaceWriterOptions& options) {
  return std::make_unique<PvtpWriter>(options);
}

}  // namespace stream_recon
