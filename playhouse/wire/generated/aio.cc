// Generated from interfaces/021_aio.toml by codegen (python3 -m codegen). Do not edit.
#include "playhouse/wire/generated/aio.h"

#include "playhouse/wire/generated/rows.h"
#include "playhouse/wire/body.h"
#include "playhouse/wire/json.h"

namespace playhouse::wire::aio {

void read(Reader& in, Data& m) {
  std::uint32_t voltages_count = 0;
  in.read(voltages_count);
  in.read_numbers(m.voltages, in.dynamic_length("voltages", voltages_count, 4));
}

void write(Writer& out, const Data& m) {
  out.write_length("voltages", m.voltages.size(), 8388598);
  out.write_length("voltages", m.voltages.size(), 8388598);
  out.write_numbers(m.voltages);
}

void to_json(std::string& out, const Data& m) {
  json_key(out, '{', "voltages");
  json_array(out, m.voltages, [](std::string& to, const auto& e) { json_value(to, e); });
  out += '}';
}

void read(Reader& in, Cmd& m) {
  in.read(m.id);
  in.read(m.voltage);
}

void write(Writer& out, const Cmd& m) {
  out.write(m.id);
  out.write(m.voltage);
}

void to_json(std::string& out, const Cmd& m) {
  json_key(out, '{', "id");
  json_value(out, m.id);
  json_key(out, ',', "voltage");
  json_value(out, m.voltage);
  out += '}';
}

const MessageDef kRows[2] = {
    {21, MessageType::kData, kDataState, "aio.data.state", "aio::Data", true, Policy::kLatest,
     check_required<Data>, reencode<Data>, body_to_json<Data>},
    {21, MessageType::kCmd, kCmdState, "aio.cmd.state", "aio::Cmd", true, Policy::kQueue,
     check_required<Cmd>, reencode<Cmd>, body_to_json<Cmd>},
};

}  // namespace playhouse::wire::aio
