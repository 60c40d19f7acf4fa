/* Lists the laws and looks at what they say of themselves. SPDX-License-Identifier: GPL-2.0-or-later */
#include "check.h"

static void look_at(const granlaw_law *l) {
  static const char *kinds[] = {"normal", "cohesion", "tangential", "rolling"};
  printf("%s %s: %s\n", kinds[l->kind], l->own_keyword, l->summary);
  EXPECT(l->id >= 48 && l->id < 64 && l->stock_id < 16);
  EXPECT(!strncmp(l->own_keyword, l->keyword, strlen(l->keyword)) && !strcmp(l->own_keyword + strlen(l->keyword), "/rs"));
  EXPECT((l->kind == GRANLAW_NORMAL) == (l->stress_strain_exponent > 0));
  for (size_t k = 0; k < l->n_props; k++) {
    const granlaw_prop *p = &l->props[k];
    printf("  %s [%s] %s\n", p->name, p->unit, p->doc);
    EXPECT(*p->name && *p->symbol && *p->unit && *p->doc && p->lo < p->hi && p->usual_lo < p->usual_hi);
    EXPECT(p->usual_lo >= p->lo && p->usual_hi <= p->hi && p->shape >= GRANLAW_SCALAR && p->shape <= GRANLAW_PER_PAIR);
  }
  for (size_t k = 0; k < l->n_settings; k++) {
    const granlaw_setting *s = &l->settings[k];
    printf("  %s", s->name);
    for (size_t o = 0; o < s->n_options; o++) printf(" %s", s->options[o]);
    printf("\n");
    EXPECT(s->n_options >= 2 && s->default_option < (int)s->n_options && *s->doc);
  }
  for (size_t k = 0; k < l->n_slots; k++) {
    printf("  keeps %s [%s]\n", l->slots[k].name, l->slots[k].unit);
    EXPECT(!strcmp(l->slots[k].newton, "0") || !strcmp(l->slots[k].newton, "1"));
  }
}

/* Which properties are needed depends on the settings. */
static void needs(void) {
  const size_t hooke = law(GRANLAW_NORMAL, "hooke");
  const granlaw_law *l = granlaw_law_at(hooke);
  int32_t options[MOST];
  for (size_t k = 0; k < l->n_settings; k++) options[k] = -1;
  options[setting(hooke, "viscous")] = 1;
  for (size_t k = 0; k < l->n_props; k++) {
    const bool viscous = !strcmp(l->props[k].name, "FluidViscosity"), fixed = !strcmp(l->props[k].name, "coefficientRestitution");
    EXPECT(granlaw_needs_property(hooke, false, NULL, k) == !(viscous || strstr(l->props[k].name, "Critical") || strstr(l->props[k].name, "Maximum")));
    if (viscous || fixed) EXPECT(granlaw_needs_property(hooke, false, options, k) == viscous);
  }
}

int main(void) {
  same_abi();
  printf("granlaw %s\n", granlaw_version());
  for (size_t k = 0; k < granlaw_law_count(); k++) look_at(granlaw_law_at(k));
  EXPECT(granlaw_law_at(granlaw_law_count()) == NULL);
  const granlaw_law *hysteresis = granlaw_law_at(law(GRANLAW_NORMAL, "hooke/hysteresis"));
  EXPECT(hysteresis->n_slots == 1 && !strcmp(hysteresis->slots[0].name, "deltaMax") && hysteresis->stock_id == 2);
  EXPECT(granlaw_law_at(law(GRANLAW_TANGENTIAL, "history"))->slots[2].newton[0] == '1');
  needs();
  return verdict();
}
