#include "app/cli/advice_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "support/plain_text.hpp"

namespace fixproof::cli {

namespace {

std::string whole(double number) {
  return support::grouped(static_cast<std::uint64_t>(std::lround(number)));
}

std::string cost_text(const trade::AdviceReport& report, const trade::Cost& cost) {
  const std::string least = whole(cost.least);
  const std::string most = whole(cost.most);
  return fmt::format("{} {}", least == most ? least : fmt::format("{} to {}", least, most),
                     trade::cost_unit(report));
}

std::string after(std::uint64_t frame) {
  return support::duration(static_cast<double>(frame) / static_cast<double>(trade::advised_rate));
}

std::string percent_text(double share) {
  return fmt::format("{:.{}f} %", 100 * share, share < 0.01 ? 2 : 1);
}

}  // namespace

std::string scene_line(const std::string& scene, std::uint64_t frames, double budget) {
  return fmt::format(
      "{}: {} frames, {} at {} frames a second; budget {} pixels.\n"
      "Pixels: the largest distance of any corner from its exact place, which double computes from "
      "scratch,\nbefore corners are rounded to whole pixels.",
      support::printable(scene), support::grouped(frames), after(frames), trade::advised_rate,
      budget);
}

std::string table_of(const trade::AdviceReport& report) {
  const bool has_bus = report.cpu == x86model::Cpu::i8088;
  const auto bus_text = [has_bus](const std::string& text) {
    return has_bus ? fmt::format("{:>11}", text) : std::string{};
  };
  std::string text = fmt::format("{:>11}{:>11}{}{:>10}  {:<7}{:<15}{}\n", "least", "most",
                                 bus_text("bus"), "pixels", "budget", "over after", "variant");
  for (const trade::Tried& tried : report.tried) {
    const auto& over = tried.error.over;
    text += fmt::format("{:>11}{:>11}{}{:>10.3f}  {:<7}{:<15}{}\n", whole(tried.cost.least),
                        whole(tried.cost.most), bus_text(whole(tried.cost.bus.value_or(0))),
                        tried.error.pixels, over ? "over" : "in", over ? after(*over) : "",
                        name_of(tried.choice));
  }
  return text;
}

std::string sentences_of(const trade::AdviceReport& report) {
  const trade::Advice advice = trade::advise(report.tried, report.budget);
  const auto at = [&](std::size_t i) { return report.tried.at(i); };
  if (!advice.take) {
    const trade::Tried nearest = at(advice.nearest);
    return fmt::format(
        "No choice stays within {} pixels. The nearest is {}: {:.3f} pixels off, {}.\n",
        report.budget, name_of(nearest.choice), nearest.error.pixels,
        cost_text(report, nearest.cost));
  }
  const trade::Tried take = at(*advice.take);
  std::string text = fmt::format("Take {}: {}, at most {:.3f} pixels off.\n", name_of(take.choice),
                                 cost_text(report, take.cost), take.error.pixels);
  if (advice.equal_cost_count > 0 && take.cost.spread > 0) {
    text += fmt::format(
        "{} other {} within the budget {} the same, given the spread of the times; this one is the "
        "most accurate.\n",
        advice.equal_cost_count, advice.equal_cost_count == 1 ? "choice" : "choices",
        advice.equal_cost_count == 1 ? "costs" : "cost");
  }
  if (report.drift_pixels) {
    text += fmt::format(
        "Over all these frames, drift measures an error of its motion of at most {:.3f} "
        "pixels{}.\n",
        *report.drift_pixels,
        // Only clipped corners can be farther off than the budget.
        *report.drift_pixels > report.budget ? ", which includes clipped corners" : "");
  }
  if (advice.runner_up) {
    const trade::Tried next = at(*advice.runner_up);
    const bool same =
        next.cost.ranked <= take.cost.ranked || trade::has_equal_cost(next.cost, take.cost);
    text += fmt::format(
        "Runner-up: {}, {}, at most {:.3f} pixels off.\n", name_of(next.choice),
        same ? "which costs the same"
             : percent_text(next.cost.ranked / take.cost.ranked - 1) + " more expensive",
        next.error.pixels);
  } else {
    text += "No other choice stays within the budget.\n";
  }
  if (!advice.next_cheaper) return text + "No choice is cheaper.\n";
  const trade::Tried cheaper = at(*advice.next_cheaper);
  text += fmt::format(
      "The next cheaper choice, {}, saves {}, but is up to {:.3f} pixels off and exceeds the "
      "budget "
      "after {}.\n",
      name_of(cheaper.choice), percent_text(1 - cheaper.cost.ranked / take.cost.ranked),
      cheaper.error.pixels, after(cheaper.error.over.value_or(0)));
  return text;
}

}  // namespace fixproof::cli
