// Keeps what a library prints on its own off standard output and standard error.
//
// While an object lives both lead to /dev/null; nothing of ours may be written then.
// Thread rule: the whole process, so one object at a time and no other thread that writes.
#pragma once

namespace stream_recon {

class QuietStreams {
 public:
  QuietStreams();
  ~QuietStreams();
  QuietStreams(const QuietStreams&) = delete;
  QuietStreams& operator=(const QuietStreams&) = delete;

 private:
  int output_;
  int error_;
};

}  // namespace stream_recon
