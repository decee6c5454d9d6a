#include "cli/advice_text.hpp"

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
    return fmt::format("None stays within {} pixels. The nearest is {}: {:.3f} pixels off, {}.\n",
                       report.budget, name_of(nearest.choice), nearest.error.pixels,
                       cost_text(report, nearest.cost));
  }
  const trade::Tried take = at(*advice.take);
  std::string text = fmt::format("Take {}: {}, at most {:.3f} pixels off.\n", name_of(take.choice),
                                 cost_text(report, take.cost), take.error.pixels);
  if (advice.as_cheap > 0 && take.cost.spread > 0) {
    text += fmt::format(
        "Within the spread of the times, {} {} within the budget {} the same; this one is the most "
        "exact.\n",
        advice.as_cheap, advice.as_cheap == 1 ? "other" : "others",
        advice.as_cheap == 1 ? "costs" : "cost");
  }
  if (report.drift_pixels) {
    text += fmt::format(
        "Its motion alone, as drift measures it over all these frames, is at most {:.3f} pixels "
        "off{}.\n",
        *report.drift_pixels,
        // Only clipped corners can be farther off than the budget.
        *report.drift_pixels > report.budget ? ", corners that are clipped among them" : "");
  }
  if (advice.runner_up) {
    const trade::Tried next = at(*advice.runner_up);
    const bool same =
        next.cost.ranked <= take.cost.ranked || trade::costs_the_same(next.cost, take.cost);
    text += fmt::format("Runner-up: {}, {}, at most {:.3f} pixels off.\n", name_of(next.choice),
                        same ? "which costs the same"
                             : percent_text(next.cost.ranked / take.cost.ranked - 1) + " dearer",
                        next.error.pixels);
  } else {
    text += "No other stays within the budget.\n";
  }
  if (!advice.next_cheaper) return text + "Nothing that was tried is cheaper.\n";
  const trade::Tried cheaper = at(*advice.next_cheaper);
  text += fmt::format(
      "The next cheaper, {}, saves {} and costs accuracy: {:.3f} pixels off at worst, over the "
      "budget after {}.\n",
      name_of(cheaper.choice), percent_text(1 - cheaper.cost.ranked / take.cost.ranked),
      cheaper.error.pixels, after(cheaper.error.over.value_or(0)));
  return text;
}

}  // namespace fixproof::cli
