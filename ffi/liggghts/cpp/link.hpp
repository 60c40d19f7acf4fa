// One link of a chain: a stock law of any kind, or consecutive Rust laws. SPDX-License-Identifier: GPL-2.0-or-later
#ifndef GRANLAW_LINK_HPP
#define GRANLAW_LINK_HPP

#include "host.hpp"

namespace granlaw {

// Passes history slots on to LIGGGHTS and remembers their names.
class Slots : public IContactHistorySetup {
 public:
  explicit Slots(IContactHistorySetup *parent) : parent_(parent) {}
  int add_history_value(std::string name, std::string newton) {
    const int at = parent_->add_history_value(name, newton);
    if (names_.size() <= static_cast<size_t>(at)) names_.resize(at + 1);
    names_[at] = name;
    return at;
  }
  const std::vector<std::string> &names() const { return names_; }

 private:
  IContactHistorySetup *parent_;
  std::vector<std::string> names_;
};

// The verbs of a LIGGGHTS model.
struct Link {
  virtual ~Link() {}
  virtual void registerSettings(Settings &) = 0;
  virtual void refuseSettings() {}
  virtual void postSettings(IContactHistorySetup *, ContactModelBase *) = 0;
  virtual void connectToProperties(PropertyRegistry &) = 0;
  virtual void beginPass(SurfacesIntersectData &, ForceData &, ForceData &) = 0;
  virtual void endPass(SurfacesIntersectData &, ForceData &, ForceData &) = 0;
  virtual void surfacesIntersect(SurfacesIntersectData &, ForceData &, ForceData &) = 0;
  virtual void endSurfacesIntersect(SurfacesIntersectData &, ForceData &, ForceData &) {}
  virtual void surfacesClose(SurfacesCloseData &, ForceData &, ForceData &) = 0;
  virtual double stressStrainExponent() { return 0.0; }
};

// A stock law.
template <class Model>
struct StockLink : Link {
  StockLink(LAMMPS *lmp, IContactHistorySetup *history, ContactModelBase *c) : model(lmp, history, c) {}
  void registerSettings(Settings &s) { model.registerSettings(s); }
  void postSettings(IContactHistorySetup *h, ContactModelBase *c) { model.postSettings(h, c); }
  void connectToProperties(PropertyRegistry &r) { model.connectToProperties(r); }
  void beginPass(SurfacesIntersectData &s, ForceData &i, ForceData &j) { model.beginPass(s, i, j); }
  void endPass(SurfacesIntersectData &s, ForceData &i, ForceData &j) { model.endPass(s, i, j); }
  void surfacesIntersect(SurfacesIntersectData &s, ForceData &i, ForceData &j) { model.surfacesIntersect(s, i, j); }
  void surfacesClose(SurfacesCloseData &s, ForceData &i, ForceData &j) { model.surfacesClose(s, i, j); }
  Model model;
};
template <int N>
struct StockNormal : StockLink<NormalModel<N> > {
  using StockLink<NormalModel<N> >::StockLink;
  double stressStrainExponent() { return this->model.stressStrainExponent(); }
};
template <int N>
struct StockCohesion : StockLink<CohesionModel<N> > {
  using StockLink<CohesionModel<N> >::StockLink;
  void endSurfacesIntersect(SurfacesIntersectData &s, ForceData &i, ForceData &j) {
    this->model.endSurfacesIntersect(s, i, j);
  }
};

// Rust laws.
struct RustLink : Link {
  RustLink(LAMMPS *lmp, IContactHistorySetup *parent) : segment(lmp, parent) {}
  void registerSettings(Settings &s) {
    for (const auto &law : segment.laws()) law->registerSettings(s);
  }
  void refuseSettings() {
    for (const auto &law : segment.laws()) law->postSettings(), law->refuseSettings();
  }
  void postSettings(IContactHistorySetup *, ContactModelBase *) {}
  void connectToProperties(PropertyRegistry &r) { segment.connectToProperties(r); }
  void beginPass(SurfacesIntersectData &, ForceData &, ForceData &) { segment.beginPass(); }
  void endPass(SurfacesIntersectData &, ForceData &, ForceData &) { segment.endPass(); }
  void surfacesIntersect(SurfacesIntersectData &s, ForceData &i, ForceData &j) { segment.surfacesIntersect(s, i, j); }
  void surfacesClose(SurfacesCloseData &s, ForceData &i, ForceData &j) { segment.surfacesClose(s, i, j); }
  double stressStrainExponent() { return segment.laws().front()->descriptor().stress_strain_exponent; }
  Segment segment;
};

// LIGGGHTS's own laws by kind and number; the lists are those of its headers.
struct Stock {
  int32_t kind;
  int id;
  const char *name;
  Link *(*make)(LAMMPS *, IContactHistorySetup *, ContactModelBase *);
};
template <class L>
Link *make_link(LAMMPS *lmp, IContactHistorySetup *h, ContactModelBase *c) {
  return new L(lmp, h, c);
}
inline const std::vector<Stock> &stock_laws() {
  static const std::vector<Stock> all = {
#define NORMAL_MODEL(CLASS, NAME, ID) {GRANLAW_NORMAL, ID, #NAME, &make_link<StockNormal<CLASS> >},
#include "style_normal_model.h"
#undef NORMAL_MODEL
#define COHESION_MODEL(CLASS, NAME, ID) {GRANLAW_COHESION, ID, #NAME, &make_link<StockCohesion<CLASS> >},
#include "style_cohesion_model.h"
#undef COHESION_MODEL
#define TANGENTIAL_MODEL(CLASS, NAME, ID) {GRANLAW_TANGENTIAL, ID, #NAME, &make_link<StockLink<TangentialModel<CLASS> > >},
#include "style_tangential_model.h"
#undef TANGENTIAL_MODEL
#define ROLLING_MODEL(CLASS, NAME, ID) {GRANLAW_ROLLING, ID, #NAME, &make_link<StockLink<RollingModel<CLASS> > >},
#include "style_rolling_model.h"
#undef ROLLING_MODEL
  };
  return all;
}
inline const Stock *stock_law(int32_t kind, int id) {
  for (const Stock &s : stock_laws())
    if (s.kind == kind && s.id == id) return &s;
  return nullptr;
}
inline const char *stock_name(int32_t kind, int id) {
  const Stock *s = stock_law(kind, id);
  return s ? s->name : "?";
}
inline std::unique_ptr<Link> stock_link(int32_t kind, int id, LAMMPS *lmp, IContactHistorySetup *h, ContactModelBase *c) {
  const Stock *s = stock_law(kind, id);
  if (!s) lmp->error->all(GRANLAW_HERE, "Unknown contact model in this chain");
  return std::unique_ptr<Link>(s->make(lmp, h, c));
}

}  // namespace granlaw
#endif
