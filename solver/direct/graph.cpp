#include "solver/direct/graph.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

namespace byhand {
namespace {

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
  explicit MinimumDegree(int nodes)
      : adjacent_(nodes), degree_(nodes), deferred_(nodes, true), gone_(nodes, false), ticket_(nodes) {}

  /// Joins two nodes. Once all are joined, `begin` is to be called.
  void join(int a, int b) {
    adjacent_[a].push_back(b);
    adjacent_[b].push_back(a);
  }
  void begin() {
    for (std::size_t node = 0; node < adjacent_.size(); ++node) {
      std::vector<int>& adjacent = adjacent_[node];
      std::sort(adjacent.begin(), adjacent.end());
      adjacent.erase(std::unique(adjacent.begin(), adjacent.end()), adjacent.end());
      degree_[node] = adjacent.size();
    }
  }
  /// Makes a deferred node eligible; returns whether it was deferred.
  bool release(int node) {
    if (!deferred_[node]) return false;
    deferred_[node] = false;
    enqueue(node);
    return true;
  }
  bool done() const { return queue_.empty(); }
  /// Numbers of lists that have been gone through; what takes as long as several counts as so many.
  long long operations() const { return operations_; }

  /// Eliminates the next eligible node and joins all its neighbours to each other.
  int eliminate() {
    const int node = std::get<2>(*queue_.begin());
    queue_.erase(queue_.begin());
    gone_[node] = true;
    const auto is_gone = [&](int other) { return gone_[other]; };
    std::vector<int>& neighbours = adjacent_[node];
    operations_ += 30 + static_cast<long long>(neighbours.size());
    std::erase_if(neighbours, is_gone);
    for (const int a : neighbours) {
      const std::size_t before = degree_[a];
      if (neighbours.size() == 1) {
        --degree_[a];  // the list of a hub stays as it is while its leaves go
      } else {
        joined_.clear();
        operations_ += static_cast<long long>(adjacent_[a].size() + neighbours.size());
        std::set_union(adjacent_[a].begin(), adjacent_[a].end(), neighbours.begin(), neighbours.end(),
                       std::back_inserter(joined_));
        std::erase_if(joined_, [&](int other) { return other == a || is_gone(other); });
        adjacent_[a] = joined_;
        degree_[a] = joined_.size();
      }
      if (!deferred_[a] && degree_[a] != before) {
        operations_ += 15;
        queue_.erase({before, ticket_[a], a});
        enqueue(a);
      }
    }
    return node;
  }

  /// The neighbours that an eliminated node had left, in ascending order.
  const std::vector<int>& later(int node) const { return adjacent_[node]; }

 private:
  void enqueue(int node) {
    ticket_[node] = next_ticket_++;
    queue_.insert({degree_[node], ticket_[node], node});
  }

  std::vector<std::vector<int>> adjacent_;  // by node, in ascending order; some may be gone
  std::vector<std::size_t> degree_;         // neighbours that are not gone
  std::vector<int> joined_;
  std::vector<bool> deferred_, gone_;
  std::vector<long> ticket_;
  std::set<std::tuple<std::size_t, long, int>> queue_;  // degree, ticket, node
  long next_ticket_ = 0;
  long long operations_ = 0;
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

int row_count(const Graph& graph) {
  int rows = 0;
  for (const Edge& edge : graph.edges) rows += edge.rows;
  return rows;
}

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

Elimination plan_elimination(const Graph& graph, int dof, long long most) {
  Elimination plan;
  const auto edges = edges_of_bodies(graph);
  const std::size_t largest_folded = has_no_loops(graph) ? 3 : 8;
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
  game.begin();

  const auto size_of = [&](int node) { return node < hubs ? graph.edges[node].rows : dof; };
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
    long long columns = 0;
    for (const int other : game.later(node)) columns += size_of(other);
    plan.multiplications += size_of(node) * columns * columns / 2;
    plan.planned = game.operations();
    if (plan.multiplications > most) return plan;
    place[node] = static_cast<int>(sequence.size());
    sequence.push_back(node);
    if (node >= hubs)
      for (const int e : edges[node - hubs])
        if (game.release(e)) break;  // one deferred edge has the hub as a body of its own
  }

  plan.multiplications = 0;
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
  for (int n = static_cast<int>(plan.nodes.size()); n-- > 0;) {
    auto& node = plan.nodes[n];
    node.root = node.first < node.last ? plan.nodes[plan.neighbours[node.first].node].root : n;
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
      const auto& target = plan.nodes[neighbour.node];
      const Elimination::Neighbour* there =
          plan.neighbours.data() + target.first;  // these follow in ascending order
      for (int b = a; b < node.last; ++b) {
        const int later = plan.neighbours[b].node;
        if (b > a)
          while (there->node < later) ++there;
        plan.targets.push_back(b > a ? there->block : target.diagonal);
        plan.multiplications += t * s * plan.nodes[later].size;  // the update
      }
      if (!coupled.contains(neighbour.block)) plan.fill_in.push_back({neighbour.block, static_cast<int>(t * s)});
    }
  }
  plan.multiplications += plan.multiplications_again;
  plan.planned += static_cast<long long>(30 * plan.couplings.size() + plan.targets.size());
  return plan;
}

std::vector<int> natural_order(int edges) {
  std::vector<int> order(edges);
  std::iota(order.begin(), order.end(), 0);
  return order;
}

std::vector<int> order_of(Layout layout, const Graph& graph) {
  if (layout == Layout::coloured) return coloured_order(graph);
  std::vector<int> order = natural_order(static_cast<int>(graph.edges.size()));
  if (layout == Layout::reverse) std::reverse(order.begin(), order.end());
  return order;
}

std::vector<int> elimination_order(const Graph& graph, int dof, Elimination& plan) {
  const long long most = most_multiplications(graph);
  plan = plan_elimination(graph, dof, most);
  if (plan.multiplications > most)
    throw std::invalid_argument("a direct solve of these " + std::to_string(graph.edges.size()) +
                                " constraints would take more than " + std::to_string(most) +
                                " multiplications a step, so many loops do they make; conjugate sweeps would do");
  return plan.order;
}

}  // namespace byhand
