#include "trade/stepping/stepping_cost.hpp"

#include <fmt/format.h>

#include <iostream>

#include "support/json.hpp"
#include "trade/clocks/claim_text.hpp"
#include "trade/figures.hpp"
#include "trade/host/provenance.hpp"
#include "xsharp/raster/span_loops.hpp"

namespace fixproof::trade {

namespace {

using support::Json;

std::string clocks_text(const Bounds& b) { return between(b.min, b.max, 1); }
Json bounds_json(const Bounds& b) { return {{"min", b.min}, {"max", b.max}}; }

void print_setups(const std::vector<SetupClocks>& setups) {
  std::cout << fmt::format(
      "\nClocks by Intel's tables; for an 8088, bus time where that is larger. Every value "
      "that a span steps takes a FixedDiv for its slope "
      "and "
      "a FixedMul\nfor its start, rounded; means of random spans.\n\n{:<18}{:>12}{:>14}\n",
      "", "divide", "multiply");
  for (const SetupClocks& s : setups) {
    std::cout << fmt::format("{:<18}{:>12}{:>14}\n", x86model::name_of(s.cpu),
                             clocks_text(s.divide), clocks_text(s.multiply));
  }
}

void print_pixels(const std::vector<PixelCost>& pixels) {
  std::cout << fmt::format(
      "\nA pixel of the document's loops, counted by DEC and JNZ; and of spans of so many pixels, "
      "with its\nshare of what they begin with.\n\n{:<18}{:<6}{:>12}",
      "", "", "pixel");
  for (const std::uint32_t length : costed_lengths) std::cout << fmt::format("{:>14}", length);
  std::cout << '\n';
  for (const PixelCost& p : pixels) {
    std::cout << fmt::format("{:<18}{:<6}{:>12}", p.loop, x86model::name_of(p.cpu),
                             clocks_text(p.pixel));
    for (const Bounds& b : p.of_span) std::cout << fmt::format("{:>14}", clocks_text(b));
    std::cout << '\n';
  }
}

void print_times(const std::vector<SteppingTimes>& times, std::uint64_t rounds) {
  std::cout << fmt::format(
      "\nNanoseconds on {}, {}: the loops in C++ over spans of {} pixels, and what a\nvalue of a "
      "span begins with; the least and the median of {} rounds.\n\n{:<26}{:>9}{:>9}{:>9}\n\n",
      processor_name(), compiler_flags(), xsharp::longest_span, rounds, "", "ns", "median",
      "spread");
  for (const SteppingTimes& t : times) {
    std::cout << fmt::format("{:<26}{:>9.3f}{:>9.3f}{:>7.1f} %  a {}\n", t.what, t.times.min,
                             t.times.median, 100 * t.times.spread, t.of);
  }
}

}  // namespace

void print_cost(const SteppingCost& cost) {
  print_setups(cost.setups);
  print_pixels(cost.pixels);
  print_times(cost.times, cost.rounds);
  std::cout << "\nWhat the document says, by these clocks.\n";
  for (const Claim& claim : cost.claims) print_claim(claim);
}

void add_cost(Json& json, const SteppingCost& cost) {
  json["setups"] = Json::array();
  for (const SetupClocks& s : cost.setups) {
    json["setups"].push_back({{"cpu", x86model::name_of(s.cpu)},
                              {"divide", bounds_json(s.divide)},
                              {"multiply", bounds_json(s.multiply)}});
  }
  json["pixels"] = Json::array();
  for (const PixelCost& p : cost.pixels) {
    Json of_span = Json::array();
    for (std::size_t i = 0; i < costed_lengths.size(); ++i) {
      of_span.push_back({{"pixels", costed_lengths.at(i)},
                         {"min", p.of_span.at(i).min},
                         {"max", p.of_span.at(i).max}});
    }
    json["pixels"].push_back({{"loop", p.loop},
                              {"cpu", x86model::name_of(p.cpu)},
                              {"values", p.values},
                              {"pixel", bounds_json(p.pixel)},
                              {"of_span", std::move(of_span)}});
  }
  json["times"] = {{"rounds", cost.rounds},
                   {"processor", processor_name()},
                   {"flags", compiler_flags()},
                   {"loops", Json::array()}};
  for (const SteppingTimes& t : cost.times) {
    json["times"]["loops"].push_back(
        {{"what", t.what},
         {"of", t.of},
         {"ns", {{"min", t.times.min}, {"median", t.times.median}, {"spread", t.times.spread}}}});
  }
  json["claims"] = Json::array();
  for (const Claim& claim : cost.claims) json["claims"].push_back(json_of_claim(claim));
}

}  // namespace fixproof::trade
