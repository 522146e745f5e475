#pragma once

/// What the page's addresses are answered with: its own files and the meshes of the world.

#include <span>

#include "playhouse/net/http.h"
#include "playhouse/web_server/mesh_files.h"
#include "playhouse/web_server/page_files.h"

namespace playhouse::web_server {

/// Of a page without files the answer says how it is built. The reply may point into `page`.
net::HttpReply page_reply(std::span<const PageFile> page, MeshFiles& meshes, const net::HttpRequest& request);

}  // namespace playhouse::web_server
