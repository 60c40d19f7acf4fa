// Settings of pair styles and walls that LIGGGHTS's own table cannot hold. SPDX-License-Identifier: GPL-2.0-or-later
#ifndef GRANLAW_WORDS_HPP
#define GRANLAW_WORDS_HPP

#include <cstring>
#include <map>
#include <string>
#include <vector>
#include "settings.h"
#include "mirror.hpp"

namespace granlaw {
using namespace LIGGGHTS;

// A setting whose options are words of its own.
class Words : public Setting {
 public:
  // LIGGGHTS's Settings keeps its table to itself and offers on/off, yes/no and numbers only.
  static void add(Settings &settings, const char *law, const granlaw_setting &s, int32_t &target) {
    Setting *&there = table(settings)[s.name];
    if (!there) there = new Words(law, s);
    target = s.default_option;
    if (Words *words = dynamic_cast<Words *>(there)) words->targets_.push_back(&target);
  }
  int parseArguments(char **args) {
    if (name != args[0]) return 0;
    std::string known;
    for (size_t o = 0; o < s_.n_options; o++) {
      if (!strcmp(s_.options[o], args[1])) {
        for (int32_t *target : targets_) *target = static_cast<int32_t>(o);
        return 2;
      }
      known += std::string(o ? ", " : "") + s_.options[o];
    }
    error_message = std::string(law_) + ": setting " + name + " " + args[1] + ": must be one of " + known;
    return -1;
  }
  void print_value(FILE *out) { fprintf(out, "%s", *targets_[0] < 0 ? "?" : s_.options[*targets_[0]]); }

 private:
  Words(const char *law, const granlaw_setting &s) : Setting(s.name, 1), law_(law), s_(s) {}
  static std::map<std::string, Setting *> &table(Settings &settings);

  const char *law_;
  const granlaw_setting &s_;
  std::vector<int32_t *> targets_;
};
// A template argument may name a private member, so this hands out Settings' table.
template <std::map<std::string, Setting *> Settings::*Table>
struct Opener {
  friend std::map<std::string, Setting *> &opened(Settings &settings) { return settings.*Table; }
};
template struct Opener<&Settings::settings>;
std::map<std::string, Setting *> &opened(Settings &settings);
inline std::map<std::string, Setting *> &Words::table(Settings &settings) { return opened(settings); }

}  // namespace granlaw
#endif
