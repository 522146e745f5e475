/// Prints every message of a recorded stream as a line of JSON: its name, its value in the format of the
/// server and `playhouse watch`, and the bytes that the value encodes to. dump FILE;
/// clients/python/tests/test_conformance.py compares the lines with the values decoded in Python.

#include <array>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "playhouse/wire/header.h"
#include "playhouse/wire/messages.h"

using namespace playhouse;

namespace {

void append_hex(const std::vector<std::byte>& bytes, std::string& out) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  for (const std::byte byte : bytes) {
    out += kDigits[std::to_integer<unsigned>(byte) >> 4];
    out += kDigits[std::to_integer<unsigned>(byte) & 15];
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  std::ifstream file(argv[1], std::ios::binary);
  const std::vector<char> chars((std::istreambuf_iterator<char>(file)), {});
  std::span<const std::byte> left = std::as_bytes(std::span(chars));
  if (std::string_view(argv[1]).ends_with(".s2c")) left = left.subspan(limits::kBannerBytes);
  while (left.size() >= limits::kHeaderBytes) {
    const wire::Header header = wire::decode_header(left.first<limits::kHeaderBytes>());
    left = left.subspan(limits::kHeaderBytes);
    if (header.size > left.size()) break;
    const wire::MessageDef* row = wire::find_message(header.interf, header.type, header.subtype);
    std::string line = "{\"name\":\"" + std::string(row != nullptr ? row->name : "") + "\",\"value\":";
    if (row != nullptr && header.size > 0) {
      row->to_json(left.first(header.size), line);
    } else {
      line += "null";
    }
    line += ",\"again\":\"";
    if (row != nullptr && row->has_payload) append_hex(row->reencode(left.first(header.size)), line);
    std::printf("%s\"}\n", line.c_str());
    left = left.subspan(header.size);
  }
  return 0;
}
