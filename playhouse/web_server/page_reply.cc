#include "playhouse/web_server/page_reply.h"

#include <algorithm>
#include <string_view>

namespace playhouse::web_server {
namespace {

constexpr std::string_view kNoPage =
    "This program was built without its web page. Build it (cd web && npm ci && npm run build), then build "
    "the program again.\n";

/// CSP: the page loads only its own files (mesh textures are
/// embedded, hence "blob:"), connects only to this server, and
/// cannot be framed, since clickjacking could drive a robot.
constexpr std::string_view kPagePolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; connect-src 'self' "
    "blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

net::HttpReply file_reply(const PageFile& file, bool accepts_gzip) {
  const bool gzip = accepts_gzip && !file.gzip.empty();
  net::HttpReply reply;
  reply.content_type = file.content_type;
  reply.content_security_policy = kPagePolicy;
  reply.etag = file.etag;
  reply.varies = !file.gzip.empty();
  reply.content_encoding = gzip ? "gzip" : "";
  reply.constant = gzip ? file.gzip : file.bytes;
  // Names below /assets/ contain a content hash.
  if (file.path.starts_with("/assets/")) reply.cache_control = "public, max-age=31536000, immutable";
  return reply;
}

}  // namespace

net::HttpReply failed_reply(unsigned status, std::string_view text) {
  net::HttpReply reply;
  reply.status = status;
  reply.constant = text;
  return reply;
}

net::HttpReply mesh_reply(const MeshFiles::File& mesh) {
  net::HttpReply reply;
  reply.content_type = "model/gltf-binary";
  reply.etag = mesh.etag;
  reply.text = mesh.bytes;
  return reply;
}

net::HttpReply page_reply(std::span<const PageFile> page, std::string_view path, bool accepts_gzip) {
  if (page.empty()) return failed_reply(503, kNoPage);
  const auto file = std::ranges::find(page, path, &PageFile::path);
  if (file == page.end()) return failed_reply(404, "There is no such page; the viewer is at /\n");
  return file_reply(*file, accepts_gzip);
}

}  // namespace playhouse::web_server
