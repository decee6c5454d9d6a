// Worked out by hand from Intel's manuals. The public sets of the 8086 and the 80286 have cases of
// each form of their processors, and the same rules hold there.
#include "tests/verify/vectors/capture.hpp"

namespace vectors {

namespace {

/// The vector of interrupt 0, which leads to 5000:0600.
const Bytes vector_0{{0, 0x00}, {1, 0x06}, {2, 0x00}, {3, 0x50}};

Bytes with_vector(Bytes bytes) {
  bytes.insert(vector_0.begin(), vector_0.end());
  return bytes;
}

const std::vector<Capture>& common() {
  static const std::vector<Capture> all{
      {"mov ax, [bx]", {0x8B, 0x07}, {}, {{0x30100, 0x34}, {0x30101, 0x12}}, {{"ax", 0x1234}}, {}},
      {"mov dx, [bp-2]",
       {0x8B, 0x56, 0xFE},
       {},
       {{0x202FE, 0x78}, {0x202FF, 0x56}},
       {{"dx", 0x5678}},
       {}},
      {"mov [di+1234h], cx",
       {0x89, 0x8D, 0x34, 0x12},
       {},
       {},
       {},
       {{0x31734, 0x22}, {0x31735, 0x20}}},
      {"mov ax, [1234h]",
       {0xA1, 0x34, 0x12},
       {},
       {{0x31234, 0x01}, {0x31235, 0x80}},
       {{"ax", 0x8001}},
       {}},
      {"mov [1234h], ax", {0xA3, 0x34, 0x12}, {}, {}, {}, {{0x31234, 0x11}, {0x31235, 0x10}}},
      {"mov dx, cs:[bx+2]",
       {0x2E, 0x8B, 0x57, 0x02},
       {},
       {{0x10102, 0xCD}, {0x10103, 0xAB}},
       {{"dx", 0xABCD}},
       {}},
      {"push bx", {0x53}, {}, {}, {{"sp", 0x01FE}}, {{0x201FE, 0x00}, {0x201FF, 0x01}}},
      {"push word [si]",
       {0xFF, 0x34},
       {},
       {{0x30400, 0x9A}, {0x30401, 0x78}},
       {{"sp", 0x01FE}},
       {{0x201FE, 0x9A}, {0x201FF, 0x78}}},
      {"pop di",
       {0x5F},
       {},
       {{0x20200, 0x21}, {0x20201, 0x43}},
       {{"sp", 0x0202}, {"di", 0x4321}},
       {}},
      {"pop word [bx]",
       {0x8F, 0x07},
       {},
       {{0x20200, 0x21}, {0x20201, 0x43}},
       {{"sp", 0x0202}},
       {{0x30100, 0x21}, {0x30101, 0x43}}},
      // 0 - 1: CF, PF, AF and SF.
      {"neg word [bp+4]",
       {0xF7, 0x5E, 0x04},
       {},
       {{0x20304, 0x01}, {0x20305, 0x00}},
       {{"flags", 0x0097}},
       {{0x20304, 0xFF}, {0x20305, 0xFF}}},
      // 7FFFh + 1: PF, AF, SF and OF.
      {"add [si], ax",
       {0x01, 0x04},
       {{"ax", 0x0001}},
       {{0x30400, 0xFF}, {0x30401, 0x7F}},
       {{"flags", 0x0896}},
       {{0x30400, 0x00}, {0x30401, 0x80}}},
      // 8000h + 8000h: CF, ZF, PF and OF.
      {"shl word [bx], 1",
       {0xD1, 0x27},
       {},
       {{0x30100, 0x00}, {0x30101, 0x80}},
       {{"flags", 0x0847}},
       {{0x30100, 0x00}, {0x30101, 0x00}}},
      {"mov al, [bx+16]", {0x8A, 0x47, 0x10}, {}, {{0x30110, 0xEE}}, {{"ax", 0x10EE}}, {}},
      {"mov [di], al", {0x88, 0x05}, {}, {}, {}, {{0x30500, 0x11}}},
      {"mov dl, dh", {0x88, 0xF2}, {}, {}, {{"dx", 0x3030}}, {}},
      {"stosb", {0xAA}, {}, {}, {{"di", 0x0501}}, {{0x40500, 0x11}}},
      {"stosw", {0xAB}, {}, {}, {{"di", 0x0502}}, {{0x40500, 0x11}, {0x40501, 0x10}}},
      {"jz +16, not taken", {0x74, 0x10}, {}, {}, {}, {}},
      {"jz +16, taken", {0x74, 0x10}, {{"flags", 0x0042}}, {}, {{"ip", 0x0022}}, {}},
      {"jg -18, taken", {0x7F, 0xEE}, {}, {}, {{"ip", 0x0000}}, {}},
      {"jmp -4096", {0xE9, 0x00, 0xF0}, {}, {}, {{"ip", 0xF013}}, {}},
      {"jmp bx", {0xFF, 0xE3}, {}, {}, {{"ip", 0x0100}}, {}},
      {"loop -2, taken", {0xE2, 0xFE}, {}, {}, {{"cx", 0x2021}, {"ip", 0x0010}}, {}},
      {"loop -2, not taken", {0xE2, 0xFE}, {{"cx", 1}}, {}, {{"cx", 0}}, {}},
      {"call +256",
       {0xE8, 0x00, 0x01},
       {},
       {},
       {{"sp", 0x01FE}, {"ip", 0x0113}},
       {{0x201FE, 0x13}, {0x201FF, 0x00}}},
      {"ret", {0xC3}, {}, {{0x20200, 0x21}, {0x20201, 0x43}}, {{"sp", 0x0202}, {"ip", 0x4321}}, {}},
  };
  return all;
}

Capture fault(std::string_view name, std::vector<int> code, int back, Bytes memory = {}) {
  return {name,
          std::move(code),
          {{"cx", 0}},
          with_vector(std::move(memory)),
          {{"sp", 0x01FA}, {"cs", 0x5000}, {"ip", 0x0600}},
          {{0x201FE, 0x02},
           {0x201FF, 0x00},
           {0x201FC, 0x00},
           {0x201FD, 0x10},
           {0x201FA, back},
           {0x201FB, 0x00}}};
}

std::vector<Capture> of_8088() {
  std::vector<Capture> all = common();
  all.push_back(fault("div cx", {0xF7, 0xF1}, 0x12));
  all.push_back(fault("div word cs:[bx]", {0x2E, 0xF7, 0x37}, 0x13, {{0x10100, 0}, {0x10101, 0}}));
  // The offset of the second byte is 0.
  all.push_back({"mov ax, [bx] at the end of the segment",
                 {0x8B, 0x07},
                 {{"bx", 0xFFFF}},
                 {{0x3FFFF, 0x34}, {0x30000, 0x12}},
                 {{"ax", 0x1234}},
                 {}});
  all.push_back({"push ax at the end of the stack",
                 {0x50},
                 {{"sp", 1}},
                 {},
                 {{"sp", 0xFFFF}},
                 {{0x2FFFF, 0x11}, {0x20000, 0x10}}});
  // FFFF:0100 is beyond the 20 address lines.
  all.push_back({"mov [bx], cx at the end of memory",
                 {0x89, 0x0F},
                 {{"ds", 0xFFFF}},
                 {},
                 {},
                 {{0x000F0, 0x22}, {0x000F1, 0x20}}});
  return all;
}

std::vector<Capture> of_286() {
  std::vector<Capture> all = common();
  all.push_back(fault("div cx", {0xF7, 0xF1}, 0x10));
  all.push_back(fault("div word cs:[bx]", {0x2E, 0xF7, 0x37}, 0x10, {{0x10100, 0}, {0x10101, 0}}));
  all.push_back({"shl cx, 4", {0xC1, 0xE1, 0x04}, {}, {}, {{"cx", 0x0220}, {"flags", 0x0002}}, {}});
  all.push_back({"push sp", {0x54}, {}, {}, {{"sp", 0x01FE}}, {{0x201FE, 0x00}, {0x201FF, 0x02}}});
  all.push_back({"mov bp, sp, IOPL set",
                 {0x89, 0xE5},
                 {{"flags", 0x3002}},
                 {},
                 {{"bp", 0x0200}, {"flags", 0x0002}},
                 {}});
  all.push_back({"mov [bx], cx beyond 1 MiB",
                 {0x89, 0x0F},
                 {{"ds", 0xFFFF}},
                 {},
                 {},
                 {{0x1000F0, 0x22}, {0x1000F1, 0x20}}});
  return all;
}

std::vector<Capture> of_386() {
  std::vector<Capture> all = common();
  all.push_back(fault("div ecx", {0x66, 0xF7, 0xF1}, 0x10));
  all.push_back({"mov eax, [bp+4]",
                 {0x66, 0x8B, 0x46, 0x04},
                 {},
                 {{0x20304, 1}, {0x20305, 2}, {0x20306, 3}, {0x20307, 4}},
                 {{"ax", 0x04030201}},
                 {}});
  all.push_back({"mov edx, cs:[bx+512]",
                 {0x2E, 0x66, 0x8B, 0x97, 0x00, 0x02},
                 {},
                 {{0x10300, 1}, {0x10301, 2}, {0x10302, 3}, {0x10303, 4}},
                 {{"dx", 0x04030201}},
                 {}});
  all.push_back({"mov [edi+256], al",
                 {0x67, 0x88, 0x87, 0x00, 0x01, 0x00, 0x00},
                 {},
                 {},
                 {},
                 {{0x30600, 0x11}}});
  all.push_back({"mov [edi*2+256], bx",
                 {0x67, 0x89, 0x1C, 0x7D, 0x00, 0x01, 0x00, 0x00},
                 {},
                 {},
                 {},
                 {{0x30B00, 0x00}, {0x30B01, 0x01}}});
  all.push_back({"mov ax, [ebp+1]",
                 {0x67, 0x8B, 0x45, 0x01},
                 {},
                 {{0x20301, 0x34}, {0x20302, 0x12}},
                 {{"ax", 0x1234}},
                 {}});
  return all;
}

}  // namespace

Values initial_registers(std::string_view cpu) {
  Values values{{"ax", 0x1011}, {"cx", 0x2022}, {"dx", 0x3033}, {"bx", 0x0100},   {"sp", 0x0200},
                {"bp", 0x0300}, {"si", 0x0400}, {"di", 0x0500}, {"cs", 0x1000},   {"ss", 0x2000},
                {"ds", 0x3000}, {"es", 0x4000}, {"ip", 0x0010}, {"flags", 0x0002}};
  if (cpu == "386") values.insert({{"fs", 0}, {"gs", 0}});
  return values;
}

const std::vector<Capture>& captures(std::string_view cpu) {
  static const std::vector<Capture> for_8088 = of_8088();
  static const std::vector<Capture> for_286 = of_286();
  static const std::vector<Capture> for_386 = of_386();
  if (cpu == "8088") return for_8088;
  return cpu == "286" ? for_286 : for_386;
}

Json json_of(const Capture& capture, std::string_view cpu) {
  Values before = initial_registers(cpu);
  for (const auto& [name, value] : capture.before) before[name] = value;
  Values after{{"ip", before["ip"] + static_cast<std::uint32_t>(capture.code.size())}};
  for (const auto& [name, value] : capture.after) after[name] = value;
  Bytes memory = capture.memory;
  for (std::size_t i = 0; i < capture.code.size(); ++i) {
    memory[0x10010 + static_cast<std::uint32_t>(i)] = capture.code[i];
  }
  Json c{{"name", capture.name}, {"bytes", capture.code}};
  if (cpu != "8088") {
    c["bytes"].push_back(0xF4);
    after["ip"] += 1;
  }
  const auto state = [&](const Values& values, const Bytes& bytes) {
    Json json{{"regs", Json::object()}, {"ram", bytes}, {"queue", Json::array()}};
    if (bytes.empty()) json["ram"] = Json::array();
    for (const auto& [name, value] : values) json["regs"][name_in_set(name, cpu)] = value;
    return json;
  };
  c["initial"] = state(before, memory);
  c["final"] = state(after, capture.written);
  return c;
}

std::string number(std::size_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 0xFFU);
  return text;
}

std::string chunk(std::string_view tag, const std::string& body) {
  return std::string(tag) + number(body.size(), 4) + body;
}

std::string moo_of(const Json& cases, std::string_view cpu) {
  static const std::vector<std::string> order_16{"ax", "bx", "cx", "dx", "cs", "ss", "ds",
                                                 "es", "sp", "bp", "si", "di", "ip", "flags"};
  static const std::vector<std::string> order_32{"cr0", "cr3", "eax", "ebx",    "ecx", "edx", "esi",
                                                 "edi", "ebp", "esp", "cs",     "ds",  "es",  "fs",
                                                 "gs",  "ss",  "eip", "eflags", "dr6", "dr7"};
  const bool wide = cpu == "386";
  const auto state = [&](const Json& json) {
    const auto& order = wide ? order_32 : order_16;
    std::uint32_t mask = 0;
    std::string values;
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (!json["regs"].contains(order[i])) continue;
      mask |= 1U << i;
      values += number(json["regs"][order[i]].get<std::uint32_t>(), wide ? 4 : 2);
    }
    std::string ram = number(json["ram"].size(), 4);
    for (const Json& byte : json["ram"]) {
      ram += number(byte[0].get<std::uint32_t>(), 4) + number(byte[1].get<std::uint32_t>(), 1);
    }
    return chunk(wide ? "RG32" : "REGS", number(mask, wide ? 4 : 2) + values) + chunk("RAM ", ram);
  };
  const std::string_view id = cpu == "8088" ? "8088" : wide ? "386E" : "C286";
  std::string file =
      chunk("MOO ", number(1, 4) + number(cases.size(), 4) + std::string(id)) + chunk("META", "x");
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Json& c = cases[i];
    const auto name = c["name"].get<std::string>();
    std::string bytes;
    for (const Json& byte : c["bytes"]) bytes += static_cast<char>(byte.get<int>());
    file += chunk("TEST", number(i, 4) + chunk("NAME", number(name.size(), 4) + name) +
                              chunk("BYTS", number(bytes.size(), 4) + bytes) +
                              chunk("INIT", state(c["initial"])) +
                              chunk("FINA", state(c["final"])) + chunk("CYCL", number(0, 4)));
  }
  return file;
}

}  // namespace vectors
