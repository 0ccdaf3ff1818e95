#pragma once

#include <cstdint>
#include <utility>

// What is kept from step to step belongs to a state of the scene, which may change, be copied or be replaced by
// another meanwhile. Whoever keeps something notes the stamp of what it was made from and compares it before use.
// Stamps are never given twice, so that no other scene has the same by chance, and copies keep them.
//
//   stamp                written by                                compared by
//   Scene::version       the scene, whenever bodies, masses,       ContactManager (find all contacts anew) and
//                        shapes or constraints change              StepWork::version (lay the rows out anew)
//   Entry::stamp         the scene, for each constraint added      System::stamp_of (keep λ of those that stay)
//   Colliders::stamps    the scene, for each body given a shape    ContactPair::stamps (keep a contact's impulses)
//   System::layout       Scene::lay_out                            what solvers and cures keep by row or block
//
// Contacts need none: they are kept beside the rows made from them, and where a step finds others it sets
// StepWork::version to 0, which is no stamp.
namespace byhand {

/// A number above 0 that no other call returns.
std::uint64_t new_stamp();

/// A stamp that copies share. What it was moved from gets a new one.
class Version {
 public:
  Version() : stamp_(new_stamp()) {}
  Version(const Version&) = default;
  Version(Version&& other) noexcept : stamp_(std::exchange(other.stamp_, new_stamp())) {}
  Version& operator=(const Version&) = default;
  Version& operator=(Version&& other) noexcept {
    stamp_ = std::exchange(other.stamp_, new_stamp());
    return *this;
  }
  ~Version() = default;

  std::uint64_t stamp() const { return stamp_; }

 private:
  std::uint64_t stamp_;
};

}  // namespace byhand
