#include "solver/direct/graph.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace byhand {
namespace {

constexpr int largest_folded = 3;  // edges of a folded body

std::vector<std::vector<int>> edges_of_bodies(const Graph& graph) {
  std::vector<std::vector<int>> edges(graph.bodies);
  for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e)
    for (const int body : {graph.edges[e].body1, graph.edges[e].body2})
      if (body != Edge::no_body) edges[body].push_back(e);
  return edges;
}

/// Elimination of nodes 0 … n-1 by minimum degree. All nodes are deferred at first.
class MinimumDegree {
 public:
  explicit MinimumDegree(int nodes) : adjacent_(nodes), deferred_(nodes, true), ticket_(nodes) {}

  void join(int a, int b) {
    adjacent_[a].insert(b);
    adjacent_[b].insert(a);
  }
  /// Makes a deferred node eligible; returns whether it was deferred.
  bool release(int node) {
    if (!deferred_[node]) return false;
    deferred_[node] = false;
    enqueue(node);
    return true;
  }
  bool done() const { return queue_.empty(); }

  /// Eliminates the next eligible node and joins all its neighbours to each other.
  int eliminate() {
    const int node = std::get<2>(*queue_.begin());
    queue_.erase(queue_.begin());
    for (const int a : adjacent_[node]) {
      const std::size_t before = adjacent_[a].size();
      adjacent_[a].erase(node);
      for (const int b : adjacent_[node])
        if (a != b) adjacent_[a].insert(b);
      if (!deferred_[a] && adjacent_[a].size() != before) {
        queue_.erase({before, ticket_[a], a});
        enqueue(a);
      }
    }
    return node;
  }

  /// The neighbours that an eliminated node had left.
  const std::set<int>& later(int node) const { return adjacent_[node]; }

 private:
  void enqueue(int node) {
    ticket_[node] = next_ticket_++;
    queue_.insert({adjacent_[node].size(), ticket_[node], node});
  }

  std::vector<std::set<int>> adjacent_;
  std::vector<bool> deferred_;
  std::vector<long> ticket_;
  std::set<std::tuple<std::size_t, long, int>> queue_;  // degree, ticket, node
  long next_ticket_ = 0;
};

/// By edge: whether it gets a folded body of its own, when each body is given to one of its edges. Leaves are
/// given away first, so that no edge of a tree goes without.
std::vector<char> with_own_body(const Graph& graph, const std::vector<std::vector<int>>& edges,
                                const std::vector<char>& folded) {
  std::vector<char> served(graph.edges.size(), 0);
  std::vector<int> unserved(graph.bodies, 0), stack;  // unserved edges by body; the next body is on top
  for (int body = 0; body < graph.bodies; ++body) {
    if (!folded[body]) continue;
    unserved[body] = static_cast<int>(edges[body].size());
    stack.push_back(body);
  }
  std::stable_partition(stack.begin(), stack.end(), [&](int body) { return unserved[body] != 1; });
  while (!stack.empty()) {
    const int body = stack.back();
    stack.pop_back();
    if (unserved[body] <= 0) continue;
    const int edge = *std::find_if(edges[body].begin(), edges[body].end(), [&](int e) { return !served[e]; });
    served[edge] = 1;
    unserved[body] = 0;
    for (const int end : {graph.edges[edge].body1, graph.edges[edge].body2})
      if (end != Edge::no_body && end != body && --unserved[end] == 1) stack.push_back(end);
  }
  return served;
}

}  // namespace

bool has_no_loops(const Graph& graph) {
  std::vector<int> parent(graph.bodies + 1);  // the last is all fixed bodies
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int body) {
    if (body == Edge::no_body) body = graph.bodies;
    while (parent[body] != body) body = parent[body] = parent[parent[body]];
    return body;
  };
  return std::all_of(graph.edges.begin(), graph.edges.end(), [&](const Edge& edge) {
    const int root1 = root(edge.body1), root2 = root(edge.body2);
    parent[root1] = root2;
    return edge.inert() || root1 != root2;
  });
}

std::vector<int> coloured_order(const Graph& graph) {
  const auto edges = edges_of_bodies(graph);
  std::vector<int> order(graph.edges.size()), colour(graph.edges.size(), -1);
  std::iota(order.begin(), order.end(), 0);
  int colours = 0;
  for (const int e : order) {
    std::vector<char> taken(colours + 1, 0);
    for (const int body : {graph.edges[e].body1, graph.edges[e].body2})
      if (body != Edge::no_body)
        for (const int other : edges[body])
          if (colour[other] >= 0) taken[colour[other]] = 1;
    colour[e] = static_cast<int>(std::find(taken.begin(), taken.end(), 0) - taken.begin());
    colours = std::max(colours, colour[e] + 1);
  }
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return colour[a] < colour[b]; });
  return order;
}

Elimination plan_elimination(const Graph& graph, int dof) {
  Elimination plan;
  const auto edges = edges_of_bodies(graph);
  for (const auto& of_body : edges) plan.folded.push_back(of_body.size() <= largest_folded);

  // Nodes are numbered by edge, hubs by body after all edges; later by their place in the sequence of elimination.
  const int hubs = static_cast<int>(graph.edges.size()), end = hubs + graph.bodies;
  MinimumDegree game(end);
  const auto couple = [&](int body, int edge, int other) {
    const auto side = [&](int node) { return node < hubs && graph.edges[node].body2 == body ? 1 : 0; };
    game.join(edge, other);
    plan.couplings.push_back({{edge, side(edge)}, {other, side(other)}});
  };
  for (int body = 0; body < graph.bodies; ++body)
    for (auto edge = edges[body].begin(); edge != edges[body].end(); ++edge)
      if (plan.folded[body])
        for (auto other = edge + 1; other != edges[body].end(); ++other) couple(body, *edge, *other);
      else
        couple(body, *edge, hubs + body);

  const auto release = [&](const std::vector<char>& eligible) {
    for (int e = 0; e < hubs; ++e)
      if (eligible[e] && !graph.edges[e].inert()) game.release(e);
  };
  const std::vector<char> all(hubs, 1);
  const bool has_hubs = std::count(plan.folded.begin(), plan.folded.end(), 0) > 0;
  release(has_hubs ? with_own_body(graph, edges, plan.folded) : all);
  for (int body = 0; body < graph.bodies; ++body)
    if (!plan.folded[body]) game.release(hubs + body);
  std::vector<int> sequence, place(end);
  while (true) {
    if (game.done()) release(all);  // no hubs are left, so that A is whole
    if (game.done()) break;
    const int node = game.eliminate();
    place[node] = static_cast<int>(sequence.size());
    sequence.push_back(node);
    if (node >= hubs)
      for (const int e : edges[node - hubs])
        if (game.release(e)) break;  // one deferred edge has the hub as a body of its own
  }

  const auto size_of = [&](int node) { return node < hubs ? graph.edges[node].rows : dof; };
  const auto allot = [&](int rows, int columns) {
    return std::exchange(plan.values, plan.values + rows * columns);
  };
  for (const int number : sequence) {
    Elimination::Node& node = plan.nodes.emplace_back();
    node.size = size_of(number);
    node.row = std::exchange(plan.unknowns, plan.unknowns + node.size);
    node.diagonal = allot(node.size, node.size);
    if (number < hubs) {
      plan.edge_size = plan.order.empty() || plan.edge_size == node.size ? node.size : 0;
      node.lambda = std::exchange(plan.edge_rows, plan.edge_rows + node.size);
      node.edge = static_cast<int>(plan.order.size());
      plan.order.push_back(number);
    } else {
      node.hub = number - hubs;
    }
    std::vector<int> later;
    for (const int other : game.later(number)) later.push_back(place[other]);
    std::sort(later.begin(), later.end());
    node.first = static_cast<int>(plan.neighbours.size());
    for (const int other : later) plan.neighbours.push_back({other, allot(size_of(sequence[other]), node.size)});
    node.last = static_cast<int>(plan.neighbours.size());
  }
  for (int e = 0; e < hubs; ++e)
    if (graph.edges[e].inert()) plan.order.push_back(e);

  const auto block_between = [&](int earlier, int later) {
    const auto& node = plan.nodes[earlier];
    if (earlier == later) return node.diagonal;
    const auto first = plan.neighbours.begin() + node.first, last = plan.neighbours.begin() + node.last;
    return std::lower_bound(first, last, later, [](const auto& n, int wanted) { return n.node < wanted; })->block;
  };
  std::set<int> coupled;  // blocks
  for (auto& [earlier, later, block, adds] : plan.couplings) {
    earlier.node = place[earlier.node];
    later.node = place[later.node];
    if (earlier.node > later.node) std::swap(earlier, later);
    block = block_between(earlier.node, later.node);
    adds = !coupled.insert(block).second;
  }
  for (const auto& node : plan.nodes) {
    const long long s = node.size;
    plan.multiplications += s * s * s;  // the inverse of the pivot
    plan.multiplications_again += s * s;
    for (int a = node.first; a < node.last; ++a) {
      Elimination::Neighbour& neighbour = plan.neighbours[a];
      const long long t = plan.nodes[neighbour.node].size;
      plan.multiplications += t * s * s;        // L
      plan.multiplications_again += 2 * t * s;  // both substitutions
      neighbour.targets = static_cast<int>(plan.targets.size());
      for (int b = a; b < node.last; ++b) {
        const int later = plan.neighbours[b].node;
        plan.targets.push_back(block_between(neighbour.node, later));
        plan.multiplications += t * s * plan.nodes[later].size;  // the update
      }
      if (!coupled.contains(neighbour.block)) plan.fill_in.push_back({neighbour.block, static_cast<int>(t * s)});
    }
  }
  plan.multiplications += plan.multiplications_again;
  return plan;
}

}  // namespace byhand
