#pragma once

/// HTTP replies for the page's files and the world's meshes.

#include <span>

#include "playhouse/net/http.h"
#include "playhouse/web_server/mesh_files.h"
#include "playhouse/web_server/page_files.h"

namespace playhouse::web_server {

/// Without embedded files the reply explains how to build the page. The reply may refer to `page`.
net::HttpReply page_reply(std::span<const PageFile> page, MeshFiles& meshes, const net::HttpRequest& request);

}  // namespace playhouse::web_server
