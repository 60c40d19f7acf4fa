// How the plugin was asked to run, and the numbers of laws. SPDX-License-Identifier: GPL-2.0-or-later
#ifndef GRANLAW_MODES_HPP
#define GRANLAW_MODES_HPP

#include <cstdlib>
#include "link.hpp"

namespace granlaw {

// own: only the /rs names are ours. rust: our laws stand behind the stock names too.
// stock: the stock names keep the stock laws, but in our chain, where they can be recorded.
enum class Laws { own, rust, stock };

// either: all contacts of a step in one call where that is possible. batched: stop where it is not. contact: never.
enum class Path { either, batched, contact };

struct Mode {
  Laws laws = Laws::own;
  Path path = Path::either;
  std::string lanes;   // how many contacts go side by side, empty for as many as the processor can
  std::string record;  // path of the trace, empty for none
  uint64_t every = 1;
  std::string probe;  // path of the probe, empty for none
  bool shadow = false;  // whether every call is held against the Rust laws
  double tolerance = 0.0;  // largest difference allowed then
  bool follow_all = false;  // whether the probe follows as many contacts as it has room for
  uint64_t steps = 0;  // of a probed run, 0 for all
  bool alarm = false;  // whether to say when the time step is too long
  std::string deck;
  std::string trouble;  // what is wrong with the environment
};

inline void read_shadow(Mode &m, const std::string &shadow, const std::string &tolerance, const std::string &laws) {
  m.shadow = shadow == "on";
  if (!shadow.empty() && shadow != "on" && shadow != "off") m.trouble = "GRANLAW_SHADOW=" + shadow + " must be on or off";
  if (m.shadow && !laws.empty() && laws != "stock")
    m.trouble = "GRANLAW_SHADOW=on runs LIGGGHTS's own laws, with the Rust laws beside them; leave GRANLAW_LAWS=" + laws + " out";
  if (tolerance.empty()) return;
  char *end = nullptr;
  m.tolerance = strtod(tolerance.c_str(), &end);
  if (*end || !(m.tolerance >= 0.0)) m.trouble = "GRANLAW_TOLERANCE=" + tolerance + " must be a number, 0 or above";
}

inline const Mode &mode() {
  static const Mode m = [] {
    Mode m;
    const auto get = [](const char *name) {
      const char *v = getenv(name);
      return std::string(v ? v : "");
    };
    const std::string laws = get("GRANLAW_LAWS");
    if (laws == "rust") m.laws = Laws::rust;
    else if (laws == "stock") m.laws = Laws::stock;
    else if (!laws.empty() && laws != "own") m.trouble = "GRANLAW_LAWS=" + laws + " must be own, rust or stock";
    const std::string path = get("GRANLAW_PATH");
    if (path == "batched") m.path = Path::batched;
    else if (path == "contact") m.path = Path::contact;
    else if (!path.empty()) m.trouble = "GRANLAW_PATH=" + path + " must be batched or contact";
    m.lanes = get("GRANLAW_LANES");
    m.record = get("GRANLAW_RECORD");
    m.probe = get("GRANLAW_PROBE");
    read_shadow(m, get("GRANLAW_SHADOW"), get("GRANLAW_TOLERANCE"), laws);
    const std::string timestep = get("GRANLAW_TIMESTEP");
    m.alarm = timestep == "warn";
    if (!timestep.empty() && !m.alarm) m.trouble = "GRANLAW_TIMESTEP=" + timestep + " must be warn";
    // LIGGGHTS's own laws can be watched only in our chain.
    if (laws.empty() && (!m.record.empty() || !m.probe.empty() || m.shadow || m.alarm)) m.laws = Laws::stock;
    m.deck = get("GRANLAW_DECK");
    const auto whole = [&](const char *name, uint64_t &number) {
      const std::string text = get(name);
      if (text.empty()) return;
      char *end = nullptr;
      number = strtoull(text.c_str(), &end, 10);
      if (*end || number == 0) m.trouble = std::string(name) + "=" + text + " must be a whole number of at least 1";
    };
    whole("GRANLAW_EVERY", m.every);
    whole("GRANLAW_STEPS", m.steps);
    const std::string follow = get("GRANLAW_FOLLOW");
    m.follow_all = follow == "all";
    if (!follow.empty() && !m.follow_all) m.trouble = "GRANLAW_FOLLOW=" + follow + " must be all";
    return m;
  }();
  return m;
}

// A stock name that is taken over gets the stock number plus this; our own numbers begin at 48.
constexpr int TAKEN = 32;
inline bool taken(int id) { return id >= TAKEN && id < 48; }

// Kinds lie in LIGGGHTS's hash code in another order than they run: normal, tangential, cohesion, rolling, surface.
inline int shift(int32_t kind) {
  static const int at[] = {0, 12, 6, 18, 24};
  return at[kind];
}
inline int id(int64_t hash, int32_t kind) { return static_cast<int>((hash >> shift(kind)) & 63); }
inline int off(int32_t kind) {
  static const int none[] = {NORMAL_OFF, COHESION_OFF, TANGENTIAL_OFF, ROLLING_OFF};
  return none[kind];
}

// The index of the Rust law with a number, or -1 where the number is the stock law's own.
inline int law_of(int32_t kind, int id) {
  for (size_t k = 0; k < granlaw_law_count(); k++) {
    const granlaw_law &d = *granlaw_law_at(k);
    if (d.kind == kind && (d.id == id || (taken(id) && d.stock_id == id - TAKEN))) return static_cast<int>(k);
  }
  return -1;
}

}  // namespace granlaw
#endif
