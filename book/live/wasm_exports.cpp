// SPDX-License-Identifier: MIT-0
// What the page may call. An instance of the module holds one figure: choose() it first.
#include <cstddef>
#include <cstdint>

#include "examine.h"
#include "fingerprint.h"

#define EXPORT(type, name) extern "C" __attribute__((export_name(#name))) type name

namespace {

std::unique_ptr<live::Figure> figure;
std::vector<live::Setting> settings;
live::Examined examined{};
double asked[7];

const live::Setting& setting(int i) {
  return settings[std::size_t(i)];
}
const live::Shown& shown(int i) {
  return figure->shown()[std::size_t(i)];
}

}  // namespace

EXPORT(int, figure_count)() {
  return int(live::figures().size());
}
EXPORT(const char*, figure_name)(int i) {
  return live::figures()[std::size_t(i)].name;
}
EXPORT(void, choose)(int i) {
  figure = live::figures()[std::size_t(i)].make();
  settings = figure->all_settings();
}

EXPORT(int, setting_count)() {
  return int(settings.size());
}
EXPORT(const char*, setting_name)(int i) {
  return setting(i).name;
}
EXPORT(void, set)(int i, double value) {
  *setting(i).value = value;
}
EXPORT(int, choice_count)(int i) {
  return int(setting(i).choices.size());
}
EXPORT(const char*, choice_name)(int i, int j) {
  return setting(i).choices[std::size_t(j)];
}

EXPORT(void, start)() {
  figure->begin();
}
EXPORT(void, advance)(int steps) {
  figure->advance(steps);
}
EXPORT(int, shown_count)() {
  return int(figure->shown().size());
}
EXPORT(const char*, shown_name)(int i) {
  return shown(i).name;
}
EXPORT(int, shown_size)(int i) {
  return int(shown(i).values.size());
}
EXPORT(const double*, shown_values)(int i) {
  return shown(i).values.data();
}

EXPORT(int, shown_changes)(int i) {
  return int(shown(i).changes);
}

EXPORT(void, examine)() {
  examined = live::examine(*live::standing());
}
EXPORT(double, examined_right_order)() {
  return examined.right_order;
}
EXPORT(double, examined_order)() {
  return examined.order;
}
EXPORT(double, examined_off)() {
  return examined.off;
}
EXPORT(double, examined_drifts)() {
  return examined.drifts;
}
EXPORT(double, examined_kicks)() {
  return examined.kicks;
}
EXPORT(const char*, examined_is)() {
  return examined.is;
}
EXPORT(double, examined_apart)() {
  return examined.apart;
}

EXPORT(void, count_reader)() {
  live::count_reader();
}
EXPORT(double*, room_to_ask)() {
  return asked;
}
EXPORT(void, answer_reader)() {
  live::answer_reader(asked);
}

EXPORT(int, bodies)() {
  return figure->bodies();
}
EXPORT(double, work)(int which, int rounds) {
  return figure->work(which, rounds);
}

EXPORT(std::uint64_t, fingerprint)(int steps) {
  return live::fingerprint(*figure, steps);
}
