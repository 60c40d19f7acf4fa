// The contact model that LIGGGHTS's pair style and wall fix run: any mix of its own laws and of Rust ones.
// SPDX-License-Identifier: GPL-2.0-or-later
#ifndef GRANLAW_CHAIN_HPP
#define GRANLAW_CHAIN_HPP

#include <dlfcn.h>
#include "counter.hpp"
#include "link.hpp"
#include "modes.hpp"
#include "watch.hpp"

namespace granlaw {

class Chain : public ContactModelBase {
 public:
  Chain(LAMMPS *lmp, IContactHistorySetup *parent, bool is_wall, const int64_t hash)
      : ContactModelBase(lmp, is_wall), lmp_(lmp), hash_(hash), slots_(parent), surface_(lmp, &slots_, this),
        watch_(lmp, parent, is_wall) {
    if (id(hash, 4) != SURFACE_DEFAULT)
      lmp->error->all(GRANLAW_HERE, "granlaw's laws need 'surface default'; leave the surface keyword out");
    for (int32_t kind : {GRANLAW_NORMAL, GRANLAW_COHESION, GRANLAW_TANGENTIAL, GRANLAW_ROLLING})
      add(kind, id(hash, kind), parent);
    Counter::enter(lmp);
    latest() = this;
  }

  // LIGGGHTS keeps its contact model private; whoever constructs one can fetch it here right afterwards.
  static Chain *&latest() {
    static Chain *chain = nullptr;
    return chain;
  }

  // Under the names that were taken over, restart files and neighbour lists see the stock law.
  int64_t hashcode() {
    int64_t hash = hash_;
    for (int32_t kind : {GRANLAW_NORMAL, GRANLAW_COHESION, GRANLAW_TANGENTIAL, GRANLAW_ROLLING})
      if (taken(id(hash_, kind))) hash -= int64_t(TAKEN) << shift(kind);
    return hash;
  }

  void registerSettings(Settings &settings) {
    surface_.registerSettings(settings);
    for (auto &link : links_) link->registerSettings(settings);
    watch_.registerSettings(settings);
  }
  void postSettings(IContactHistorySetup *) {
    for (auto &link : links_) link->refuseSettings();  // before LIGGGHTS prepares for what is refused
    surface_.postSettings(&slots_, this);
    for (auto &link : links_) link->postSettings(&slots_, this);
    watch_.postSettings();
  }
  void connectToProperties(PropertyRegistry &registry) {
    surface_.connectToProperties(registry);
    for (auto &link : links_) link->connectToProperties(registry);
    watch_.connectToProperties(registry, slots_.names());
  }

  void beginPass(SurfacesIntersectData &s, ForceData &i, ForceData &j) {
    surface_.beginPass(s, i, j);
    for (auto &link : links_) link->beginPass(s, i, j);
    watch_.begin();
  }
  void endPass(SurfacesIntersectData &s, ForceData &i, ForceData &j) {
    for (auto link = links_.rbegin(); link != links_.rend(); ++link) (*link)->endPass(s, i, j);
    surface_.endPass(s, i, j);
  }
  bool checkSurfaceIntersect(SurfacesIntersectData &s) { return surface_.checkSurfaceIntersect(s); }

  void surfacesIntersect(SurfacesIntersectData &s, ForceData &i, ForceData &j) {
    watch_.before(s);
    surface_.surfacesIntersect(s, i, j);
    for (auto &link : links_) link->surfacesIntersect(s, i, j);
  }
  void endSurfacesIntersect(SurfacesIntersectData &s, TriMesh *mesh, ForceData &i, ForceData &j) {
    surface_.endSurfacesIntersect(s, mesh, i.delta_F);
    for (auto &link : links_) link->endSurfacesIntersect(s, i, j);
    watch_.touched(s, i, j);
  }
  void surfacesClose(SurfacesCloseData &s, ForceData &i, ForceData &j) {
    watch_.before(s);
    surface_.surfacesClose(s, i, j);
    for (auto &link : links_) link->surfacesClose(s, i, j);
    watch_.parted(s, i, j);
  }

  double stressStrainExponent() { return links_.empty() ? 0.0 : links_.front()->stressStrainExponent(); }
  void tally_pp(double val, int i, int j, int index) { surface_.tally_pp(val, i, j, index); }
  void tally_pw(double val, int i, int j, int index) { surface_.tally_pw(val, i, j, index); }
  bool contact_match(const std::string type, const std::string model) {
    ContactModels::Factory &f = ContactModels::Factory::instance();
    if (type == "surface") return id(hash_, 4) == f.getSurfaceModelId(model);
    if (type == "normal") return id(hash_, GRANLAW_NORMAL) == f.getNormalModelId(model);
    if (type == "cohesion") return id(hash_, GRANLAW_COHESION) == f.getCohesionModelId(model);
    if (type == "tangential") return id(hash_, GRANLAW_TANGENTIAL) == f.getTangentialModelId(model);
    if (type == "rolling_friction") return id(hash_, GRANLAW_ROLLING) == f.getRollingModelId(model);
    return false;
  }

  bool watched() const { return watch_.on(); }
  // The Rust laws where the chain has no others, else NULL.
  const Segment *rust() const { return segment_ && links_.size() == 1 ? &segment_->segment : nullptr; }

 private:
  void add(int32_t kind, int id, IContactHistorySetup *parent) {
    if (id == off(kind)) return;
    const int index = law_of(kind, id);
    const bool stock = taken(id) && mode().laws == Laws::stock;
    if (index < 0 || stock) {
      const size_t at = slots_.names().size();
      links_.push_back(stock_link(kind, stock ? id - TAKEN : id, lmp_, &slots_, this));
      segment_ = nullptr;
      watch_.stock(kind, index, stock_name(kind, stock ? id - TAKEN : id), at);
      return;
    }
    if (!segment_) links_.emplace_back(segment_ = new RustLink(lmp_, parent));
    watch_.rust(kind, index, &segment_->segment.add(&slots_, index, taken(id)));
  }

  LAMMPS *lmp_;
  int64_t hash_;
  Slots slots_;
  SurfaceModel<SURFACE_DEFAULT> surface_;
  std::vector<std::unique_ptr<Link> > links_;
  RustLink *segment_ = nullptr;  // the last link while it is one of ours
  Watch watch_;
};

}  // namespace granlaw
#endif
