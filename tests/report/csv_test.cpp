// Tables for other programs.
#include "cli/report/csv.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/json.hpp"

namespace {

using namespace fixproof;
using support::Json;

TEST(Csv, QuotesWhatHasToBe) {
  const Json rows{{{"name", "plain"}, {"note, with comma", 1.5}},
                  {{"name", "say \"hi\""}, {"note, with comma", nullptr}},
                  {{"name", "two\nlines"}, {"note, with comma", true}}};
  EXPECT_EQ(cli::csv_text(rows),
            "name,\"note, with comma\"\r\n"
            "plain,1.5\r\n"
            "\"say \"\"hi\"\"\",\r\n"
            "\"two\nlines\",true\r\n");
  EXPECT_EQ(cli::csv_text(Json::array()), "");
}

std::string text_of(const Json& report, const std::string& name) {
  const auto files = cli::csv_files(report);
  const auto found =
      std::find_if(files.begin(), files.end(), [&](const auto& f) { return f.first == name; });
  return found == files.end() ? "no such file" : found->second;
}

TEST(Csv, HasATableForWhatWasMeasured) {
  EXPECT_TRUE(cli::csv_files({{"accuracy", nullptr}, {"host", nullptr}}).empty());
  const Json drift{
      {"frames_a_point", 5},
      {"cases", {{{"name", "a, b"}, {"series", {{"length", {0.5, 0.25}}, {"pixels", {1, 2}}}}}}}};
  EXPECT_EQ(text_of({{"drift", drift}}, "drift.csv"),
            "case,from_frame,length,pixels\r\n\"a, b\",0,0.5,1\r\n\"a, b\",5,0.25,2\r\n");
}

TEST(Csv, OfClocksWithAndWithoutAMean) {
  const Json spread{{"least", 7}, {"most", 9}, {"calls", 0}};
  const Json mean{{"least", 7}, {"most", 9}, {"calls", 2}, {"mean", {{"min", 7.5}, {"max", 8}}}};
  const Json clocks{{"clocks",
                     {{{"routine", "mul"},
                       {"target", "i386"},
                       {"chapter", 54},
                       {"rounds", true},
                       {"instructions", spread},
                       {"processors",
                        {{{"cpu", "386"}, {"clocks", mean}},
                         {{"cpu", "8088"}, {"clocks", mean}, {"bus", mean}, {"limit", "table"}}}},
                       {"faults", 0}}}},
                    {"claims", Json::array()}};
  EXPECT_EQ(text_of({{"clocks", clocks}}, "clocks.csv"),
            "routine,target,chapter,rounds,cpu,instructions_least,instructions_mean_min,"
            "instructions_mean_max,instructions_most,clocks_least,clocks_mean_min,clocks_mean_max,"
            "clocks_most,bus_mean,limit,calls,faults\r\n"
            "mul,i386,54,true,386,7,,,9,7,7.5,8,9,,,2,0\r\n"
            "mul,i386,54,true,8088,7,,,9,7,7.5,8,9,8,table,2,0\r\n");
}

TEST(Csv, OfHostTimesWhereOneHasNoChain) {
  const Json host{
      {"host",
       {{{"contender", "a"}, {"chain_ns", nullptr}, {"throughput_ns", {{"min", 1}}}},
        {{"contender", "b"}, {"chain_ns", {{"min", 3}}}, {"throughput_ns", {{"min", 2}}}}}},
      {"vertices", Json::array()}};
  EXPECT_EQ(text_of({{"host", host}}, "host.csv"),
            "contender,throughput_ns_min,chain_ns_min\r\na,1,\r\nb,2,3\r\n");
}

TEST(Csv, SteppingWithoutItsListsAndAlongSpans) {
  const Json row{
      {"value", "depth"},
      {"rule", "cut"},
      {"last", {{"max", 1}, {"bound", 2}}},
      {"along",
       {{{"pixel", 0}, {"max", 3}, {"bound", 4}}, {{"pixel", 9}, {"max", 5}, {"bound", 6}}}},
      {"last_of", Json::array()}};
  const Json stepping{{"stepping", Json::array({row})}};
  EXPECT_EQ(text_of({{"stepping", stepping}}, "stepping.csv"),
            "value,rule,last_max,last_bound\r\ndepth,cut,1,2\r\n");
  EXPECT_EQ(text_of({{"stepping", stepping}}, "along.csv"),
            "value,rule,pixel,max,bound\r\ndepth,cut,0,3,4\r\ndepth,cut,9,5,6\r\n");
}

}  // namespace
