#include "cli/report/findings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command_line.hpp"
#include "fixed/fixed.hpp"
#include "support/json.hpp"
#include "support/plain_text.hpp"
#include "x86model/call.hpp"
#include "x86model/call_loop.hpp"
#include "x86model/forms.hpp"
#include "x86model/parse.hpp"
#include "xsharp/arithmetic.hpp"
#include "xsharp/project.hpp"
#include "xsharp/shapes.hpp"

namespace fixproof::cli {

namespace {

namespace x86 = x86model;
using fixed::q16_16;
using support::Json;

/// One question, and what was answered.
struct Asked {
  std::string who;
  std::string question;
  std::string answer;
};

struct Finding {
  std::string title;
  std::string test;
  std::string says;
  std::vector<Asked> cases;
};

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  while (!text.empty()) {
    const auto space = std::min(text.find(' '), text.size());
    if (space > 0) words.emplace_back(text.substr(0, space));
    text.remove_prefix(std::min(space + 1, text.size()));
  }
  return words;
}

std::string output_of(const std::string& command, const std::string& input = {}) {
  Captured captured = run_captured(words_of(command), input);
  if (captured.status != 0) throw std::runtime_error("cannot run: fixproof " + command);
  while (captured.out.ends_with('\n')) captured.out.pop_back();
  return captured.out;
}

/// A line for `eval`.
Asked evaluated(std::string who, const std::string& input, const std::string& command) {
  return {std::move(who), fmt::format("echo {} | fixproof eval {}", input, command),
          output_of("eval " + command, input)};
}

/// The lines of a trace that hold `wanted`; the last line where that is empty.
Asked traced(std::string who, const std::string& command, std::string_view wanted) {
  std::string text = output_of("trace " + command);
  Asked asked{std::move(who), "fixproof trace " + command, {}};
  if (wanted.empty()) {
    asked.answer = text.substr(text.rfind('\n') + 1);
    return asked;
  }
  text += '\n';
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = text.find('\n', at);
    const std::string line = text.substr(at, end - at);
    if (line.find(wanted) != std::string::npos) {
      asked.answer += (asked.answer.empty() ? "" : "\n") + line;
    }
    at = end + 1;
  }
  return asked;
}

template <class Number>
std::string hex(Number x) {
  return fmt::format("{:08x}", static_cast<std::uint32_t>(x.raw()));
}

q16_16 raw(std::int32_t units) { return q16_16::from_raw(units); }

/// Whether the element of a transform, twelve doublewords in a memory of no more, can be stored.
std::string stored(std::uint32_t row, std::uint32_t column) {
  x86::WordMemory<16, 24> transform;
  return transform.write(4 * (4 * row + column), 0) ? "stored" : "no such place";
}

std::string has_instruction(x86::Target target) {
  const auto instruction = x86::parse("shl bx, 2");
  if (!instruction) throw std::runtime_error("cannot parse shl bx, 2");
  return x86::is_modelled(*instruction, target) ? "executes it" : "does not have it";
}

/// XformVec where destination and source are one vector, (1, 2, 3), under the transform that swaps
/// x and y.
std::string swapped_in_place(x86::Target target) {
  constexpr std::uint32_t one = 0x10000;
  const std::vector<std::uint32_t> in{0, one, 0,   0, one, 0,       0,      0,
                                      0, 0,   one, 0, one, 2 * one, 3 * one};
  x86::CallMachine<x86::Routine::xformvec, 16> machine;
  x86::enter<x86::Routine::xformvec>(machine, in);
  // Above the return address: WorkingXform, SourceVec, DestVec.
  const std::uint32_t sp = machine.registers.read(x86::Register::sp, x86::Size::word);
  std::uint32_t source = 0;
  machine.memory.read(sp + 4, source);
  machine.memory.write(sp + 6, source);
  const x86::Program program =
      x86::assemble(x86::listing(x86::Routine::xformvec, target), x86::Build{});
  if (x86::run(program.instructions(), machine).outcome != x86::Outcome::returned) return "broken";
  std::string words;
  for (std::uint32_t at = source; at < source + 12; at += 4) {
    std::uint32_t low = 0;
    std::uint32_t high = 0;
    machine.memory.read(at, low);
    machine.memory.read(at + 2, high);
    words += fmt::format("{}{:08x}", words.empty() ? "" : " ", high << 16U | low);
  }
  return words;
}

/// What a loop draws that is entered for `count` pixels, in a segment full of 1s.
std::string pixels_drawn(const x86::LoopForm& form, std::uint32_t count) {
  std::vector<std::uint8_t> data(0x100);
  std::vector<std::uint8_t> extra(0x10000, 1);
  x86::LoopMachine machine{.registers = {}, .memory = x86::ByteMemory(data, extra, data)};
  constexpr std::uint64_t most_steps = 1'000'000;
  const auto ending = x86::call_loop(
      form, x86::code_of(form), machine, {.pixels = count},
      [](std::size_t, const x86::LoopMachine&) {}, most_steps);
  if (ending.outcome == x86::Outcome::step_limit) return "no end within a million instructions";
  const auto drawn = std::count(extra.begin(), extra.end(), 0);
  return fmt::format("{} pixels", support::grouped(static_cast<std::uint64_t>(drawn)));
}

/// Whether the depth test reaches the depth of a pixel, by its number on a screen of 320 by 200.
std::string depth_reached(std::uint32_t pixel) {
  std::vector<std::uint8_t> segment(0x10000);
  x86::LoopMachine machine{.registers = {}, .memory = x86::ByteMemory(segment, segment, segment)};
  const x86::LoopForm form{.loop = x86::Loop::depth_test};
  // The buffer takes its segment from the beginning.
  const auto begin = static_cast<std::uint32_t>(x86::address_of(x86::Symbol::z_buff));
  const auto ending = x86::call_loop(form, x86::code_of(form), machine,
                                     {.pixels = 1, .place = pixel - begin / 2, .value = 0});
  return ending.outcome == x86::Outcome::returned ? "tested" : "beyond its segment";
}

/// A move by (4, 5, 6), then one by (1, 2, 3): two transforms, row by row.
constexpr const char* two_moves =
    "00010000 00000000 00000000 00010000 00000000 00010000 00000000 00020000 "
    "00000000 00000000 00010000 00030000 00010000 00000000 00000000 00040000 "
    "00000000 00010000 00000000 00050000 00000000 00000000 00010000 00060000";

std::vector<Finding> first_findings() {
  return {
      {"A switch that reads the wrong way round",
       "Defects.InvertedSwitch",
       "The 8088 divide rounds where its printed switch says that it does not. 2 / 3, with the "
       "switches as printed.",
       {evaluated("386", "00020000 00030000", "div --target i386 --as-printed"),
        evaluated("8088", "00020000 00030000", "div --target i8088 --as-printed")}},
      {"Halves",
       "Defects.Ties",
       "Halves go up on the 386, away from zero on the 8088; unrounded, one floors and the other "
       "truncates. Minus one unit times 0.5.",
       {evaluated("386, rounded", "ffffffff 00008000", "mul --target i386"),
        evaluated("8088, rounded", "ffffffff 00008000", "mul --target i8088"),
        evaluated("386, unrounded", "ffffffff 00008000", "mul --target i386 --round off"),
        evaluated("8088, unrounded", "ffffffff 00008000", "mul --target i8088 --round off"),
        {"q16_16", "from_raw(-1) * q16_16(0.5)", hex(raw(-1) * q16_16(0.5))}}},
      {"A fault that vanishes",
       "Defects.VanishingFault",
       "Rounded, the 386 divide takes an unsigned quotient for a signed one: two positive numbers "
       "give a negative one, and no fault.",
       {evaluated("386, rounded", "00008001 00000001", "div --target i386 --round on"),
        evaluated("386, unrounded", "00008001 00000001", "div --target i386 --round off"),
        {"q16_16_saturating", "from_raw(0x8001) / from_raw(1)",
         hex(fixed::q16_16_saturating::from_raw(0x8001) / fixed::q16_16_saturating::from_raw(1))}}},
      {"Half of the divisor",
       "Defects.HalfRangeDivisor",
       "The 8088 divides by the whole part of the divisor: one just below 2 counts as 1, one below "
       "1 is a divide error.",
       {evaluated("386", "0000ffff 0001ffff", "div --target i386"),
        evaluated("8088", "0000ffff 0001ffff", "div --target i8088"),
        evaluated("8088", "00010000 0000ffff", "div --target i8088")}},
      {"One unit too high",
       "Defects.DoubleToFixed",
       "The published conversion adds a half and truncates: negative constants become a unit too "
       "large. The constant -1.0.",
       {{"published conversion", "-1.0",
         hex(raw(xsharp::raw_constant(-1.0, xsharp::Conversion::published)))},
        {"q16_16", "q16_16(-1.0)", hex(q16_16(-1.0))}}},
      {"The translation in every column",
       "Defects.TranslationInEveryColumn",
       "Chapter 52 adds the first transform's translation to all four sums of a row, not to the "
       "fourth alone. A move by (1, 2, 3) after one by (4, 5, 6).",
       {evaluated("chapter 54", two_moves, "concat"),
        evaluated("chapter 52", two_moves, "concat --chapter 52")}},
  };
}

std::vector<Finding> last_findings() {
  return {
      {"An element that is not there",
       "Defects.OutOfBounds",
       "A transform has twelve elements, three rows of four. Chapter 52 stores into row 3, column "
       "3, which would be the sixteenth. That is row 0, column 3 of the next transform, "
       "which the program writes again before it reads it.",
       {{"model", "row 2, column 3", stored(2, 3)}, {"model", "row 3, column 3", stored(3, 3)}}},
      {"Not an instruction of the 8088",
       "Defects.NotAn8088Instruction",
       "CosSin shifts by two in one instruction in its 8088 branch too. The 8088 shifts by one or "
       "by CL.",
       {{"386", "shl bx, 2", has_instruction(x86::Target::i386)},
        {"8088", "shl bx, 2", has_instruction(x86::Target::i8088)}}},
      {"Not in place",
       "Defects.InPlace",
       "XformVec writes each coordinate before it reads the source for the next. ConcatXforms does "
       "so with elements. Swapping x and y of (1, 2, 3).",
       {evaluated("386, apart",
                  "00000000 00010000 00000000 00000000 00010000 00000000 00000000 00000000 "
                  "00000000 00000000 00010000 00000000 00010000 00020000 00030000",
                  "xformvec"),
        {"386, in place", "the same, destination and source one vector",
         swapped_in_place(x86::Target::i386)},
        {"8088, in place", "the same, destination and source one vector",
         swapped_in_place(x86::Target::i8088)}}},
      {"A carry that means nothing",
       "Defects.AdcAfterEndif",
       "A scan moved the last ADC of the 8088 divide out of the conditional: it then adds a carry "
       "that DIV leaves undefined. 2.5 / 2, unrounded.",
       {traced("8088, as scanned", "div 00028000 00020000 --target i8088 --round off --as-scanned",
               ""),
        evaluated("8088, the author's code", "00028000 00020000",
                  "div --target i8088 --round off")}},
      {"Arguments that are not the callee's",
       "Defects.ClobberedArguments",
       "The 8088 divide negates the low words of its operands where the caller pushed them. "
       "-0.25 / -2.75.",
       {traced("8088", "div ffffc000 fffd4000 --target i8088", "neg word")}},
      {"What rounding adds",
       "Defects.Comments",
       "One comment has rounding add a unit, another half a unit. Half a unit becomes a unit, "
       "less becomes 0. Six more comments contradict their code.",
       {evaluated("386", "00000001 00008000", "mul"),
        evaluated("386", "00000001 00007fff", "mul")}},
  };
}

std::vector<Finding> loop_findings() {
  using enum x86::Counting;
  const x86::LoopForm bytes{.loop = x86::Loop::gouraud_byte};
  const x86::LoopForm words{.loop = x86::Loop::gouraud_word};
  return {
      {"A shift right that is none",
       "Defects.ShrdForShld",
       "The depth loop says that SHRD EBX,EDX,24 is EDX shifted right by 8. It puts EDX, shifted "
       "left by 8, above the top byte of EBX; SHLD does what is meant. A depth of 12h and 34h/256.",
       {traced("as printed", "depth 00000001 00001234 00000000 --as-printed", "shrd"),
        traced("with SHLD", "depth 00000001 00001234 00000000", "shld")}},
      {"Nothing to draw",
       "Defects.NoPixels",
       "A loop that counts at its end draws at least one pixel. For none it counts on: in 16-bit "
       "code LOOP draws 65,536, DEC ECX 4,294,967,296. An unrolled loop draws none.",
       {{"LOOP", "GouraudBytes, 0 pixels", pixels_drawn(bytes, 0)},
        {"DEC, JNZ", "GouraudBytes, 0 pixels",
         pixels_drawn({.loop = x86::Loop::gouraud_byte, .counting = dec_jnz}, 0)},
        {"unrolled", "GouraudBytes, 0 pixels",
         pixels_drawn({.loop = x86::Loop::gouraud_byte, .counting = unrolled}, 0)}}},
      {"The odd pixel",
       "Defects.OddPixel",
       "Two pixels a store: SHR ECX,1 drops the last of an odd number. One pixel makes no pair, "
       "for which the loop draws 65,536 words. The source tells the caller to write odd pixels as "
       "bytes.",
       {{"LOOP", "GouraudWords, 7 pixels", pixels_drawn(words, 7)},
        {"LOOP", "GouraudWords, 1 pixel", pixels_drawn(words, 1)}}},
      {"The depth test and what is said of it",
       "Defects.DepthTestWords",
       "The text says not to write a pixel whose depth is greater; the code writes it. A "
       "buffer that begins at minus infinity agrees with the code: the text's rule would draw "
       "nothing.",
       {traced("depth 1 over 0", "depth 00000001 00000100 00000000", "inc edi"),
        traced("depth -1 over 0", "depth 00000001 ffffff00 00000000", "inc edi")}},
      {"A buffer larger than its segment",
       "Defects.BufferBeyondSegment",
       "320 by 200 depths of two bytes are 128,000 bytes. A segment of 16-bit code has 65,536: "
       "from the middle of line 102 on EDI*2 faults.",
       {{"386", "pixel 32767", depth_reached(32767)},
        {"386", "pixel 32768", depth_reached(32768)}}},
  };
}

/// Two transforms, each a move along x: by 0.5, and after one by the word `second`.
std::string half_after(std::string_view second) {
  constexpr std::string_view rest =
      "00000000 00010000 00000000 00000000 00000000 00000000 00010000 00000000";
  return fmt::format("00010000 00000000 00000000 00008000 {0} 00010000 00000000 00000000 {1} {0}",
                     rest, second);
}

std::vector<Finding> carry_findings() {
  return {
      {"A lost carry",
       "Defects.LostCarry",
       "The 8088 ConcatXforms adds the high word of the translation with ADD, not ADC. Where the "
       "low words carry, the result is 1.0 too low. A move by 0.5 after one by 0.5, and after one "
       "by 1.5.",
       {evaluated("8088", half_after("00008000"), "concat --target i8088"),
        evaluated("8088, repaired", half_after("00008000"), "concat --target i8088 --repaired"),
        evaluated("8088", half_after("00018000"), "concat --target i8088"),
        evaluated("386", half_after("00008000"), "concat --target i386")}},
  };
}

/// By how many degrees the author's generator turns the normals of a ball: it subtracts the first
/// vertex from the cross product before it scales that to length 1.
std::string lean_of_normals(double radius) {
  double least = 180;
  double most = 0;
  const xsharp::Mesh body = xsharp::ball(radius, 6);
  for (const xsharp::Face& face : body.faces) {
    const xsharp::Triple& base = body.vertices[face.vertices[0]];
    const auto edge_to = [&](std::size_t vertex) {
      return xsharp::difference(body.vertices[vertex], base);
    };
    const xsharp::Triple inward =
        xsharp::cross(edge_to(face.vertices[1]), edge_to(face.vertices.back()));
    const xsharp::Triple leaning = xsharp::difference(inward, base);
    const double angle =
        std::atan2(xsharp::length(xsharp::cross(inward, leaning)), xsharp::dot(inward, leaning));
    least = std::min(least, angle * 180 / std::numbers::pi);
    most = std::max(most, angle * 180 / std::numbers::pi);
  }
  return fmt::format("{:.1f} to {:.1f} degrees off", least, most);
}

std::vector<Finding> normal_findings() {
  return {
      {"Normals that lean",
       "Defects.WrongNormals",
       "The author's generator of the ball, which is not printed, subtracts a vertex from each "
       "normal before it scales the normal to length 1. Normals lean more on smaller "
       "balls.",
       {{"radius 25", "72 faces", lean_of_normals(25)},
        {"radius 60", "72 faces", lean_of_normals(60)}}},
  };
}

std::vector<Finding> projection_findings() {
  const xsharp::Scene scene;
  const auto from_middle = [&scene](std::int32_t x) {
    using N = fixed::q16_16_i386;
    const auto projection = xsharp::projection_of<N>(scene);
    const xsharp::Vec3<N> place{N(x), N(0), N(-100)};
    const auto pixel = xsharp::project(place, projection);
    if (!pixel) throw std::runtime_error("a divide error at z = -100");
    return fmt::format("{} pixels from the middle", pixel->x - projection.center_x);
  };
  return {
      {"Half the width",
       "Defects.HalfTheWidth",
       "A comment calls the projection ratio distance over width; the code multiplies it by half "
       "the width. The edge of the screen is 160 pixels from the middle.",
       {evaluated("x over z", "00320000 ff9c0000", "div"),
        evaluated("times the constant", "ffff8000 fec00001", "mul"),
        {"code", "x = 50, z = -100", from_middle(50)},
        {"comment's edge", "x = 25, z = -100", from_middle(25)}}},
  };
}

/// What the texture loop draws, texels being numbered by their columns.
std::string texels_drawn(std::uint32_t from_column, std::uint32_t count) {
  std::vector<std::uint8_t> segment(0x10000);
  const auto texture = static_cast<std::size_t>(x86::address_of(x86::Symbol::texture));
  constexpr std::size_t columns = 16;
  for (std::size_t i = 0; i < columns; ++i) segment.at(texture + i) = static_cast<std::uint8_t>(i);
  std::vector<std::uint8_t> row(0x10000);
  x86::LoopMachine machine{.registers = {}, .memory = x86::ByteMemory(segment, row, segment)};
  const x86::LoopForm form{.loop = x86::Loop::texture};
  x86::call_loop(form, x86::code_of(form), machine,
                 {.pixels = count, .value = from_column << 8U, .step = 1U << 8U});
  return fmt::format("{}", fmt::join(std::span(row).first(count), " "));
}

std::vector<Finding> texture_findings() {
  return {
      {"A step before the fetch",
       "Defects.StepBeforeFetch",
       "The pseudo-code of a texture steps its coordinates and then fetches the texel; the "
       "assembly fetches first. They are one pixel apart. Three pixels from column 1, a "
       "column each.",
       {{"assembly", "from column 1", texels_drawn(1, 3)},
        {"pseudo-code", "a step further, from column 2", texels_drawn(2, 3)}}},
  };
}

}  // namespace

support::Json computed_findings() {
  std::vector<Finding> all = first_findings();
  for (Finding& finding : last_findings()) all.push_back(std::move(finding));
  for (Finding& finding : loop_findings()) all.push_back(std::move(finding));
  for (Finding& finding : carry_findings()) all.push_back(std::move(finding));
  for (Finding& finding : normal_findings()) all.push_back(std::move(finding));
  for (Finding& finding : projection_findings()) all.push_back(std::move(finding));
  for (Finding& finding : texture_findings()) all.push_back(std::move(finding));
  Json json = Json::array();
  for (const Finding& finding : all) {
    Json cases = Json::array();
    for (const Asked& asked : finding.cases) {
      cases.push_back({{"who", asked.who}, {"asked", asked.question}, {"answer", asked.answer}});
    }
    json.push_back({{"number", json.size() + 1},
                    {"title", finding.title},
                    {"test", finding.test},
                    {"says", finding.says},
                    {"cases", std::move(cases)}});
  }
  return json;
}

}  // namespace fixproof::cli
