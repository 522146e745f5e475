#pragma once

/// HTTP replies for files of pages and the world's meshes.

#include <span>
#include <string_view>

#include "playhouse/net/http.h"
#include "playhouse/web_server/mesh_files.h"
#include "playhouse/web_server/page_files.h"

namespace playhouse::web_server {

/// Without embedded files the reply explains how to build the page. The reply may refer to `page`.
net::HttpReply page_reply(std::span<const PageFile> page, std::string_view path, bool accepts_gzip);
net::HttpReply mesh_reply(const MeshFiles::File& mesh);
/// Text of static lifetime.
net::HttpReply failed_reply(unsigned status, std::string_view text);

}  // namespace playhouse::web_server
