// XML as a stream of events, read as far as it is asked and no further.
//
// Guarantees: well-formed up to the last event returned. When an event for a tag is returned, the
// source stands right behind that tag's '>': what follows need not be XML (VTK's appended data).
// No document type declarations, so no entity bombs; at most kDeepest elements inside each other.
// Memory: one piece of text (kLongestText bytes), or one tag, which must fit the source's window.
// Thread rule: one reader. The one door to expat is xml_reader.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/byte_source.h"

struct XML_ParserStruct;

namespace stream_recon {

struct XmlEvent {
  enum class Kind { kStart, kEnd, kText, kFinished };
  Kind kind = Kind::kFinished;
  std::string name;  ///< of the element; at kText the text
  std::vector<std::pair<std::string, std::string>> attributes;

  /// The attribute's value, empty where it is missing.
  std::string_view attribute(std::string_view attribute_name) const;
};

class XmlReader {
 public:
  static constexpr std::size_t kLongestText = std::size_t{16} * 1024;
  static constexpr int kDeepest = 64;

  explicit XmlReader(ByteSource& source);
  ~XmlReader();
  XmlReader(const XmlReader&) = delete;
  XmlReader& operator=(const XmlReader&) = delete;

  /// kFinished at the end of the document. \throw InputError not well-formed, or cut short
  XmlEvent next();

  ByteSource& source() const { return source_; }

 private:
  struct Callbacks;

  void feed();

  ByteSource& source_;
  XML_ParserStruct* parser_;
  std::deque<XmlEvent> pending_;
  const char* refusal_ = nullptr;  ///< what a callback found wrong
  int depth_ = 0;
  bool finished_ = false;
};

}  // namespace stream_recon
