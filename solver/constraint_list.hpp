#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <vector>

#include "solver/constraint.hpp"

namespace byhand {

/// Constraints of any kinds in natural order, the order in which they came: those of a scene, or the contacts that
/// a ContactManager has found.
template <class M>
class ConstraintList {
 public:
  /// A constraint by its kind's store and its index there, with its bodies.
  struct Entry {
    int kind = 0, index = 0;
    int id = 0;  // ascending
    int body1 = 0, body2 = 0;
    std::uint64_t stamp = 0;  // see support/stamp.hpp
  };

  ConstraintList() = default;
  ConstraintList(const ConstraintList& other) : entries_(other.entries_) {
    for (const auto& store : other.stores_) stores_.push_back(store->clone());
  }
  ConstraintList(ConstraintList&&) noexcept = default;
  ConstraintList& operator=(ConstraintList other) noexcept {
    stores_.swap(other.stores_);
    entries_.swap(other.entries_);
    return *this;
  }

  int count() const { return static_cast<int>(entries_.size()); }
  const std::vector<Entry>& entries() const { return entries_; }
  const ConstraintStore<M>& store(int kind) const { return *stores_[kind]; }
  /// The place of a constraint, -1 if there is none.
  int find(int id) const {
    const auto entry = std::ranges::lower_bound(entries_, id, {}, &Entry::id);
    return entry != entries_.end() && entry->id == id ? static_cast<int>(entry - entries_.begin()) : -1;
  }
  /// The constraint of an entry, whose kind this is.
  template <class Kind>
  const Kind& of(const Entry& entry) const {
    return typed<Kind>(entry.kind).all[entry.index];
  }
  /// All constraints of a kind.
  template <class Kind>
  std::span<const Kind> all() const {
    const int kind = kind_of<Kind>();
    if (kind < 0) return {};
    return typed<Kind>(kind).all;
  }

  /// Adds a constraint, with an id larger than all others, or leaves the list as it was.
  template <class Kind>
  void add(const Kind& constraint, int id, std::uint64_t stamp = 0) {
    if (entries_.size() == entries_.capacity()) entries_.reserve(2 * entries_.size() + 8);
    int kind = kind_of<Kind>();
    if (kind < 0) {
      kind = static_cast<int>(stores_.size());
      stores_.push_back(make_store<M, Kind>());
    }
    auto& all = typed<Kind>(kind).all;
    all.push_back(constraint);
    const int index = static_cast<int>(all.size()) - 1;
    entries_.push_back({kind, index, id, constraint.at.body1, constraint.at.body2, stamp});
  }
  /// Puts another constraint of its kind in the place of an entry's, on the same bodies.
  template <class Kind>
  void replace(const Entry& entry, const Kind& constraint) {
    typed<Kind>(entry.kind).all[entry.index] = constraint;
  }
  void remove(int place) {
    const Entry entry = entries_[place];
    stores_[entry.kind]->erase(entry.index);
    entries_.erase(entries_.begin() + place);
    for (Entry& other : entries_)
      if (other.kind == entry.kind && other.index > entry.index) --other.index;
  }
  /// Removes all, and keeps their memory.
  void clear() {
    for (const auto& store : stores_) store->clear();
    entries_.clear();
  }

 private:
  template <class Kind>
  int kind_of() const {
    for (std::size_t kind = 0; kind < stores_.size(); ++kind)
      if (stores_[kind]->kind() == typeid(Kind)) return static_cast<int>(kind);
    return -1;
  }
  template <class Kind>
  Constraints<M, Kind>& typed(int kind) const {
    return static_cast<Constraints<M, Kind>&>(*stores_[kind]);
  }

  std::vector<std::unique_ptr<ConstraintStore<M>>> stores_;
  std::vector<Entry> entries_;
};

}  // namespace byhand
