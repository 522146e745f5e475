#include "playhouse/app/commands/shared_options.h"

#include <filesystem>

#include "playhouse/app/discovery/announce.h"
#include "playhouse/base/limits.h"

namespace playhouse::app {
namespace {

void add_lock_step(CLI::App& app, Running& running) {
  auto* lock_step = add_parsed(app, "--lock-step", parse_lock_step, running.lock_step,
                               "each tick waits for a step of one client, of N, or of those with these names "
                               "(docs/lock-step.md)")
                        ->type_name("[N | NAME,NAME,...]")
                        ->expected(0, 1);
  app.add_option("--lock-step-timeout", running.lock_step_timeout,
                 "drop a client that is silent for so many seconds (never)")
      ->check(check_positive)
      ->needs(lock_step);
}

void add_cluster(CLI::App& app, Running& running) {
  auto* cluster = app.add_option("--cluster", running.cluster,
                                 "port for nodes, which share the work (none; docs/cluster.md)")
                      ->type_name("PORT")
                      ->check(check_port);
  app.add_option("--nodes", running.nodes, "nodes to wait for before the first tick")
      ->check(check_count<std::size_t, 0, limits::kClusterNodes>)
      ->capture_default_str()
      ->needs(cluster);
  app.add_option("--cluster-token", running.cluster_token,
                 "that nodes have to have (beyond this machine a random one, printed; on it none)")
      ->type_name("TOKEN")
      ->check(check_token)
      ->needs(cluster);
}

/// Whoever forges the sender of a datagram has data sent to others.
void check_udp(const Serving& serving) {
  if (!serving.udp || serving.is_controlled() || !is_for_others(serving.bind)) return;
  throw CLI::ValidationError("--udp with --bind " + serving.bind +
                             ": senders of datagrams can be forged: --guests or --key keeps data from them");
}

/// Everybody on the network can read what goes to a group, and its addresses are of IPv4.
void check_multicast(const Serving& serving) {
  if (!serving.multicast || serving.bind == "::" || serving.bind.find(':') == std::string::npos) return;
  throw CLI::ValidationError("--multicast with --bind " + serving.bind +
                             ": a group of IPv4 is reached from an IPv4 address, 0.0.0.0 or ::");
}

}  // namespace

void add_engine(CLI::App& app, std::string& engine) {
  app.add_option("--engine", engine,
                 "simulation engine: stage, 2D, or arena, 3D rigid bodies (docs/arena.md)")
      ->type_name("NAME")
      ->check(check_engine)
      ->capture_default_str();
}

void add_seed(CLI::App& app, std::uint64_t& seed, const std::string& help) {
  app.add_option("--seed", seed, help)->check(check_count<std::uint64_t>)->capture_default_str();
}

void add_workers(CLI::App& app, unsigned& workers, const std::string& help) {
  app.add_option("--workers", workers, help)->check(check_workers)->capture_default_str();
}

void add_allowed_libraries(CLI::App& app, Running& running) {
  app.add_option("--allow-library", running.allowed_libraries,
                 "allow a library outside the library folders; may be repeated")
      ->type_name("FILE.so")
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

void add_bind(CLI::App& app, std::string& address) {
  app.add_option("--bind", address, "address to listen on; 0.0.0.0: every interface")
      ->check(check_bind)
      ->capture_default_str();
}

void add_insecure(CLI::App& app, bool& insecure, const std::string& otherwise) {
  app.add_flag("--insecure", insecure, "let everybody who reaches --bind ADDRESS do everything" + otherwise);
}

void check_bind_insecure(const std::string& bind, bool insecure) {
  if (insecure || !is_for_others(bind)) return;
  throw CLI::ValidationError(
      "--bind " + bind +
      ": everybody on the network could drive the robots, without a token: --insecure allows it");
}

void check_access(const Serving& serving) {
  check_udp(serving);
  check_multicast(serving);
  const std::string& bind = serving.bind;
  if (serving.insecure || serving.is_controlled() || !is_for_others(bind)) return;
  throw CLI::ValidationError("--bind " + bind +
                             ": everybody on the network could do everything: --guests gives tokens to those "
                             "who may, --key one to all, --insecure allows it");
}

void add_auth_key(CLI::App& app, std::string& token) {
  app.add_option("--token", token, "token of a guest, for a run with --guests")->check(check_auth_key);
}

void add_hosts(CLI::App& app, Serving& serving) {
  add_bind(app, serving.bind);
  add_insecure(app, serving.insecure, ", without --guests or --key");
  app.add_option("--web-host", serving.web_hosts, "a further host name for the page; may be repeated")
      ->check(check_web_host)
      ->expected(1)
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  add_parsed(app, "--trusted-proxy", net::TrustedProxies::parse, serving.proxies,
             "reverse proxies in front of the page, whose X-Forwarded-For counts")
      ->type_name("ADDRESS,...");
  auto* certificate =
      app.add_option("--tls-cert", serving.tls_cert,
                     "speak TLS on the ports of page and Player clients, with this PEM certificate")
          ->type_name("FILE");
  auto* key = app.add_option("--tls-key", serving.tls_key, "its private key, PEM, without a passphrase")
                  ->type_name("FILE");
  certificate->needs(key);
  key->needs(certificate);
  auto* guests = app.add_option("--guests", serving.guests,
                                "access control by role: observer, driver, human or admin (docs/guests.md)")
                     ->type_name("FILE");
  app.add_option("--key", serving.key, "the key that everybody has to know who comes, in place of --guests")
      ->check(check_key)
      ->excludes(guests);
  app.add_option("--viewers", serving.viewers, "limit on simultaneous pages, and on observers")
      ->check(check_count<std::size_t, 1, limits::kViewers>)
      ->capture_default_str();
  app.add_option("--page-bytes", serving.page_bytes, "limit in bytes per second of state for each page")
      ->type_name("N")
      ->check(check_page_bytes)
      ->capture_default_str();
  auto* observers =
      app.add_option("--observers", serving.observers,
                     "UDP port for playhouse observe; 0: any free one, printed (none; docs/observers.md)")
          ->type_name("PORT")
          ->check(check_port);
  app.add_option("--observer-bytes", serving.observer_bytes, "limit in bytes per second for each observer")
      ->type_name("N")
      ->check(check_observer_bytes)
      ->capture_default_str()
      ->needs(observers);
}

void add_serving(CLI::App& app, Serving& serving) {
  app.add_option("--port", serving.port, "port for Player clients; 0: any free one, printed")
      ->check(check_port)
      ->capture_default_str();
  add_parsed(app, "--web", parse_web, serving.web,
             "port of the web page, or off; 0: any free one, printed (8080)");
  add_hosts(app, serving);
  app.add_option("--unix", serving.unix_folder,
                 "serve Player clients by Unix sockets as well: FOLDER/PORT for each port")
      ->type_name("FOLDER")
      ->check(check_folder)
      ->transform([](const std::string& folder) { return std::filesystem::absolute(folder).string(); }, "");
  app.add_flag("--udp", serving.udp, "serve Player clients by UDP as well, on the same ports")
      ->excludes("--tls-cert");
  add_parsed(app, "--multicast", parse_group, serving.multicast,
             "send data once to this multicast group for all clients that ask for it, in the clear (none)")
      ->type_name("GROUP[:PORT]")
      ->excludes("--tls-cert")
      ->excludes("--guests")
      ->excludes("--key");
  app.add_option("--client-memory", serving.client_mib,
                 "limit in MiB of memory for what Player clients have sent in part and have not read")
      ->type_name("MIB")
      ->check(check_count<std::size_t, limits::kClientMiBLeast, limits::kClientMiBMost>)
      ->capture_default_str();
  // CLI11 runs callbacks in the order of definition: this overrides --web.
  app.add_flag_callback(
      "--headless", [&serving] { serving.web.reset(); }, "no web page, as --web off");
}

void add_recording(CLI::App& app, Running& running) {
  auto* record =
      app.add_option("--record", running.record, "record the run to an MCAP file (docs/recording.md)")
          ->type_name("FILE.mcap");
  app.add_option("--record-only", running.record_only,
                 "recorded besides poses: kinds, @NAMES or KIND@NAME, comma-separated; poses: nothing else "
                 "(everything)")
      ->type_name("WHAT,...")
      ->check(check_selection)
      ->needs(record);
}

void add_running(CLI::App& app, Running& running) {
  add_engine(app, running.engine);
  auto* fast = app.add_flag_callback(
      "--fast", [&running] { running.speed = 0; }, "as fast as possible instead of real time");
  app.add_option("--speed", running.speed, "times real time; 0: as fast as possible (the file's speedup)")
      ->check(check_not_negative)
      ->excludes(fast);
  app.add_option("--duration", running.duration,
                 "simulated seconds after which the run ends (run: the file's quit_time)")
      ->check(check_not_negative);
  add_seed(app, running.seed);
  add_workers(app, running.workers, kWorkersOfARun);
  add_allowed_libraries(app, running);
  app.add_option("--save-world", running.save_world,
                 "file that a client's SAVE request writes the current world to (interface simulation)")
      ->type_name("FILE.world");
  add_recording(app, running);
  add_lock_step(app, running);
  add_cluster(app, running);
  app.add_flag("--paused", running.paused, "start paused, until a viewer or a client resumes the run");
  app.add_flag("--json", running.json, "print the result as the last line of standard output");
}

}  // namespace playhouse::app
