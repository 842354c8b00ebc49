// SPDX-License-Identifier: MIT-0
#include "frames/log.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <catch2/matchers/catch_matchers_vector.hpp>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "../measure/folder.h"

using Catch::Matchers::Approx;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;

namespace {

std::vector<double> read(const std::string& text) {
  const Folder folder;
  std::ofstream(folder.path / "log.csv", std::ios::binary) << text;
  return frames::read_log(folder.path / "log.csv");
}

void refuses(const std::string& text, const std::string& why) {
  CAPTURE(text);
  CHECK_THROWS_MATCHES(read(text), std::runtime_error, MessageMatches(ContainsSubstring(why)));
}

/// Three frames of 16, 17 and 34 ms.
const std::vector<double> three{0.016, 0.017, 0.034};

const std::string present_mon_1 =
    "Application,ProcessID,SwapChainAddress,Runtime,SyncInterval,PresentFlags,Dropped,"
    "TimeInSeconds,msInPresentAPI,msBetweenPresents\r\n"
    "game.exe,7,0x01,DXGI,1,0,0,1.0,0.1,0.000\r\n"
    "game.exe,7,0x01,DXGI,1,0,0,1.016,0.1,16\r\n"
    "game.exe,7,0x01,DXGI,1,0,0,1.033,0.1,17.000\r\n"
    "game.exe,7,0x01,DXGI,1,0,0,1.067,0.1,34.000\r\n";

const std::string mangohud_head =
    "os,cpu,gpu,ram,kernel,driver,cpuscheduler\n"
    "Debian,Some CPU @ 3.0GHz,,32148228,6.1,,performance\n"
    "fps,frametime,cpu_load,gpu_load,elapsed\n";

}  // namespace

TEST_CASE("A log of PresentMon 1 is known by msBetweenPresents, and its first row is no frame") {
  CHECK_THAT(read(present_mon_1), Approx(three));
}

TEST_CASE("A log of PresentMon 2 is known by FrameTime, or by MsBetweenAppStart") {
  CHECK_THAT(read("Application,ProcessID,CPUStartTime,FrameTime,CPUBusy\ngame.exe,7,0,16,3\n"
                  "game.exe,7,16,17,3\ngame.exe,7,33,34,3\ngame.exe,7,67,NA,3\n"),
             Approx(three));
  CHECK_THAT(read("Application,MsCPUBusy,MsBetweenAppStart\ngame.exe,2,16\ngame.exe,2,17\n"
                  "game.exe,2,34\n"),
             Approx(three));
}

TEST_CASE("A log of CapFrameX as CSV has comments above the names of its columns") {
  CHECK_THAT(read("\xEF\xBB\xBF//GameName=game.exe\n//Comment=a, b\n"
                  "Application,ProcessID,TimeInSeconds,MsBetweenPresents,MsInPresentAPI\n"
                  "game.exe,7,0.1,16,0.2\ngame.exe,7,0.2,17,0.2\ngame.exe,7,0.3,34,0.2\n"),
             Approx(three));
}

TEST_CASE("A byte order mark is no part of the first name, and names may stand in quotes") {
  CHECK_THAT(read("\xEF\xBB\xBF\"MsBetweenPresents\", \"Application\"\n\"16\",game.exe\n"
                  "17,game.exe\n34,game.exe\n"),
             Approx(three));
}

TEST_CASE("A log of CapFrameX as JSON has frames in each of its runs") {
  CHECK_THAT(read(R"({"Info": {"GameName": "game"}, "Runs": [
                      {"CaptureData": {"MsBetweenPresents": [0, 16, 17]}},
                      {"CaptureData": {"MsBetweenPresents": [34]}}]})"),
             Approx(three));
}

TEST_CASE("A log of MangoHud is in milliseconds or in microseconds, as its fps tell") {
  CHECK_THAT(read(mangohud_head + "62.5,16,3,40,100\n58.82,17,3,40,17000100\n"
                                  "29.41,34,3,40,51000100\n"),
             Approx(three));
  CHECK_THAT(read(mangohud_head + "62.5,16000,3,40,100\n58.82,17000,3,40,17000100\n"
                                  "29.41,34000,3,40,51000100\n"),
             Approx(three));
}

TEST_CASE("A log of MangoHud may begin with its version") {
  CHECK_THAT(
      read("v1\n0.7.1\n---------------------SYSTEM INFO---------------------\n" + mangohud_head +
           "62.5,16,3,40,100\n58.82,17,3,40,17000100\n"
           "29.41,34,3,40,51000100\n"),
      Approx(three));
}

TEST_CASE("A column of numbers without a name is in seconds") {
  CHECK_THAT(read("0.016\n0.017\n\n0.034\n"), Approx(three));
}

TEST_CASE("Frames of a third of a millisecond with hitches are frames") {
  std::string text = "MsBetweenPresents\n";
  for (int n = 0; n < 100; ++n) text += n % 50 == 49 ? "17.2\n" : "0.35\n";
  CHECK(read(text).size() == 100);
}

TEST_CASE("What is no length of a frame is refused by its row") {
  refuses(present_mon_1 + "game.exe,7,0x01,DXGI,1,0,0,1.1,0.1,-2\n", "row 6: '-2' is no length");
  refuses(present_mon_1 + "game.exe,7,0x01,DXGI,1,0,0,1.1,0.1,fast\n",
          "row 6: 'fast' is no number");
  refuses(present_mon_1 + "game.exe,7,0x01,DXGI,1,0,0,1.1,0.1,nan\n", "row 6: 'nan' is no length");
  refuses(present_mon_1 + "game.exe,7,0x01\n", "row 6: it has too few columns");
  refuses("0.016\n0\n0.017\n", "row 2: '0' is no length");
  refuses("0.016\n61\n0.017\n", "row 2: '61' is no length");
  refuses("0.016\n0.017 s\n", "row 2: '0.017 s' is no number");
  refuses("0.016\n0.017,3\n", "row 2: it has more columns");
  refuses(R"({"Runs": [{"CaptureData": {"MsBetweenPresents": [16, -1]}}]})", "frame 2 takes -1");
}

TEST_CASE("What is no log, or of no use, is refused") {
  refuses("", "it is empty");
  refuses("time,speed\n1,2\n", "no row names a column MsBetweenPresents");
  refuses("MsBetweenPresents\n16\n", "fewer than two frames");
  refuses(mangohud_head, "fewer than two frames");
  refuses("16.7\n16.6\n17\n", "these may be milliseconds");
  refuses("{\"Runs\": 3}", "it is not of CapFrameX");
  refuses("{", "it is not of CapFrameX");
  CHECK_THROWS_MATCHES(
      frames::read_log("/nowhere/log.csv"), std::runtime_error,
      MessageMatches(ContainsSubstring("/nowhere/log.csv: there is no such file")));
}

TEST_CASE("Frames of two programs are refused") {
  refuses(present_mon_1 + "dwm.exe,8,0x02,DXGI,1,0,0,1.1,0.1,16\n",
          "row 6: it is of dwm.exe, and those before are of game.exe");
}

TEST_CASE("A log of MangoHud that has not every frame is refused") {
  refuses(mangohud_head + "62.5,16,3,40,100\n58.82,17,3,40,100000100\n29.41,34,3,40,200000100\n",
          "log_interval=0");
  refuses(mangohud_head + "62.5,16,3,40,100\n62.5,0.016,3,40,200\n62.5,0.016,3,40,300\n",
          "neither a second in milliseconds");
}
