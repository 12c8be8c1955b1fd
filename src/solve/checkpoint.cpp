#include "solve/checkpoint.hpp"

namespace ashlar {

void exchange_field(Exchange& e, const std::string& name, Backend& backend, Field field) {
  std::vector<double> values;
  if (!e.taking()) values = backend.save(field);
  e("field." + name, values);
  if (e.taking()) backend.restore(field, values);
}

void exchange(Exchange& e, const std::string& name, CrackEvent& event) {
  e(name + ".load_factor", event.load_factor);
  e(name + ".place", event.place);
  e(name + ".contact_points", event.contact_points);
  e(name + ".interface", event.interface);
  e(name + ".mode", event.mode);
  e(name + ".seconds", event.seconds);
}

void exchange(Exchange& e, const std::string& name, EnergyBalance& energy) {
  for (double* part :
       {&energy.kinetic, &energy.strain, &energy.dissipated, &energy.external_work, &energy.error, &energy.drift})
    e(name, *part);
  e(name + ".contacts", energy.contacts);
}

void exchange(Exchange& e, const std::string& name, Dissipation<double>& lost) {
  for (double* part : {&lost.opening, &lost.shear, &lost.friction}) e(name, *part);
}

void exchange(Exchange& e, const std::string& name, LooseBlocks& loose) {
  e(name + ".blocks", loose.blocks);
  e(name + ".region", loose.region);
  e(name + ".volume", loose.volume);
  e(name + ".centre", loose.centre);
}

void exchange(Exchange& e, const std::string& name, InitialBalance& balance) {
  e(name + ".share", balance.share);
  e(name + ".largest", balance.largest);
  e(name + ".place", balance.place);
}

void exchange(Exchange& e, const std::string& name, LaneTimes& lanes) {
  e(name + ".stress_device", lanes.stress_device);
  e(name + ".heat_device", lanes.heat_device);
  e(name + ".beside", lanes.beside);
  e(name + ".heat_steps", lanes.heat_steps);
  for (double* seconds : {&lanes.stress, &lanes.heat, &lanes.both}) e(name + ".seconds", *seconds);
}

void exchange(Exchange& e, const std::string& name, PhaseTime& time) {
  e(name + ".name", time.phase);
  e(name + ".seconds", time.seconds);
}

void exchange(Exchange& e, const std::string& name, StageResult& s) {
  for (auto* text : {&s.name, &s.kind, &s.stop_reason}) e(name + ".text", *text);
  e(name + ".converged", s.converged);
  e(name + ".steps", s.steps);
  for (double* number : {&s.ratio, &s.load_factor, &s.wall_seconds, &s.cracked_area, &s.dissipated_energy,
                         &s.plastic_work, &s.fracture_work, &s.safety_factor, &s.falling_factor, &s.seconds,
                         &s.time_step, &s.stable_step})
    e(name + ".number", *number);
  e(name + ".activity", s.activities);
  e(name + ".phase", s.phases);
  e(name + ".event", s.events);
  e(name + ".direction", s.cracked_area_by_direction);
  e(name + ".free_block", s.free_blocks);
  e(name + ".loose", s.loose);
  e(name + ".by_contacts", s.dissipated_by_contacts);
  e(name + ".initial", s.initial);
  e(name + ".lanes", s.lanes);
  e(name + ".energy", s.energy);
}

void exchange(Exchange& e, const std::string& name, HistoryTable::Row& row) {
  e(name + ".stage", row.stage);
  e(name + ".time", row.time);
  e(name + ".load_factor", row.load_factor);
  e(name + ".value", row.values);
  e(name + ".balanced", row.balanced);
}

}  // namespace ashlar
