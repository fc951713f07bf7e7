#include "io/xml_reader.h"

#include <expat.h>

#include <algorithm>
#include <new>

namespace stream_recon {

struct XmlReader::Callbacks {
  static void start(void* user, const XML_Char* name, const XML_Char** attributes) {
    auto& reader = *static_cast<XmlReader*>(user);
    if (++reader.depth_ > kDeepest) return refuse(reader, "elements are nested too deep");
    XmlEvent event{XmlEvent::Kind::kStart, name, {}};
    for (; *attributes != nullptr; attributes += 2) {
      event.attributes.emplace_back(attributes[0], attributes[1]);
    }
    reader.pending_.push_back(std::move(event));
  }

  static void end(void* user, const XML_Char* name) {
    auto& reader = *static_cast<XmlReader*>(user);
    --reader.depth_;
    reader.pending_.push_back({XmlEvent::Kind::kEnd, name, {}});
  }

  static void text(void* user, const XML_Char* bytes, int length) {
    auto& pending = static_cast<XmlReader*>(user)->pending_;
    if (pending.empty() || pending.back().kind != XmlEvent::Kind::kText) {
      pending.push_back({XmlEvent::Kind::kText, {}, {}});
    }
    pending.back().name.append(bytes, static_cast<std::size_t>(length));
  }

  static void doctype(void* user, const XML_Char*, const XML_Char*, const XML_Char*, int) {
    refuse(*static_cast<XmlReader*>(user), "document type declarations are not read");
  }

  static void refuse(XmlReader& reader, const char* why) {
    reader.refusal_ = why;
    XML_StopParser(reader.parser_, XML_FALSE);
  }
};

std::string_view XmlEvent::attribute(std::string_view attribute_name) const {
  for (const auto& [key, value] : attributes) {
    if (key == attribute_name) return value;
  }
  return {};
}

XmlReader::XmlReader(ByteSource& source) : source_(source), parser_(XML_ParserCreate(nullptr)) {
  if (parser_ == nullptr) throw std::bad_alloc();
  XML_SetUserData(parser_, this);
  XML_SetElementHandler(parser_, Callbacks::start, Callbacks::end);
  XML_SetCharacterDataHandler(parser_, Callbacks::text);
  XML_SetStartDoctypeDeclHandler(parser_, Callbacks::doctype);
}

XmlReader::~XmlReader() {
  XML_ParserFree(parser_);
}

XmlEvent XmlReader::next() {
  while (pending_.empty()) {
    if (finished_) return {};
    feed();
  }
  XmlEvent event = std::move(pending_.front());
  pending_.pop_front();
  return event;
}

// The parser gets a tag as a whole and nothing behind it, or text up to the next tag: so it never
// holds an unfinished tag back, and an event leaves the source where its contract says.
void XmlReader::feed() {
  std::string_view piece = source_.peek(1);
  if (piece.starts_with('<')) {
    std::size_t end = piece.find('>');
    while (end == std::string_view::npos && piece.size() < ByteSource::kWindow) {
      const std::size_t before = piece.size();
      piece = source_.peek(before + 1);
      if (piece.size() == before) break;
      end = piece.find('>', before);
    }
    if (end == std::string_view::npos && piece.size() >= ByteSource::kWindow) {
      source_.fail("an XML tag does not end; the file is damaged");
    }
    piece = piece.substr(0, end == std::string_view::npos ? end : end + 1);
  } else {
    piece = piece.substr(0, kLongestText);
    piece = piece.substr(0, piece.find('<'));
  }
  finished_ = piece.empty();
  const XML_Status status =
      XML_Parse(parser_, piece.data(), static_cast<int>(piece.size()), finished_ ? 1 : 0);
  if (status != XML_STATUS_OK) {
    const char* why = refusal_ != nullptr ? refusal_ : XML_ErrorString(XML_GetErrorCode(parser_));
    source_.fail(std::string("XML: ") + why +
                 (finished_ ? "; the file is cut short, fetch it again" : "; the file is damaged"));
  }
  source_.consume(piece.size());
}

}  // namespace stream_recon
