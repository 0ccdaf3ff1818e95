#include "solver/direct/graph.hpp"

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>

namespace byhand {
namespace {

constexpr int largest_folded = 3;

std::vector<std::vector<int>> edges_of_bodies(const Graph& graph) {
  std::vector<std::vector<int>> edges(graph.bodies);
  for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e)
    for (const int body : {graph.edges[e].body1, graph.edges[e].body2})
      if (body != Edge::no_body) edges[body].push_back(e);
  return edges;
}

/// The elimination game on nodes 0 … n-1, by minimum degree.
class Game {
 public:
  explicit Game(int nodes) : adjacent_(nodes), waiting_(nodes, false), ticket_(nodes), later_(nodes) {}

  void join(int a, int b) {
    if (a == b) return;
    adjacent_[a].insert(b);
    adjacent_[b].insert(a);
  }
  void let_wait(int node) { waiting_[node] = true; }

  void start() {
    for (int node = 0; node < static_cast<int>(adjacent_.size()); ++node)
      if (!waiting_[node]) enqueue(node);
  }
  bool over() const { return queue_.empty(); }

  /// Lets a node go that waits; returns whether it did.
  bool release(int node) {
    if (!waiting_[node]) return false;
    waiting_[node] = false;
    enqueue(node);
    return true;
  }

  /// Eliminates the next node and makes its neighbours a clique.
  int eliminate() {
    const int node = std::get<2>(*queue_.begin());
    queue_.erase(queue_.begin());
    const std::vector<int> clique(adjacent_[node].begin(), adjacent_[node].end());
    for (const int a : clique) {
      const std::size_t before = adjacent_[a].size();
      adjacent_[a].erase(node);
      for (const int b : clique)
        if (a != b) adjacent_[a].insert(b);
      if (!waiting_[a] && adjacent_[a].size() != before) {
        queue_.erase({before, ticket_[a], a});
        enqueue(a);
      }
    }
    later_[node] = clique;
    return node;
  }

  const std::vector<int>& later(int node) const { return later_[node]; }

 private:
  void enqueue(int node) {
    ticket_[node] = next_ticket_++;
    queue_.insert({adjacent_[node].size(), ticket_[node], node});
  }

  std::vector<std::set<int>> adjacent_;
  std::vector<bool> waiting_;
  std::vector<long> ticket_;
  std::vector<std::vector<int>> later_;
  std::set<std::tuple<std::size_t, long, int>> queue_;
  long next_ticket_ = 0;
};

/// Which edges can have a folded body each, no two the same. Leaves are given away first, so that trees are served
/// whole.
std::vector<char> with_own_body(const Graph& graph, const std::vector<std::vector<int>>& edges,
                                const std::vector<char>& folded) {
  std::vector<char> served(graph.edges.size(), 0);
  std::vector<int> unserved(graph.bodies, 0), stack;  // what is pushed last is given away first
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

long long multiplications(const Elimination& plan) {
  long long count = 0;
  for (const auto& node : plan.nodes) {
    const long long s = node.size;
    count += s * s * s + s * s;  // inverse of the pivot and its product with the right-hand side
    long long rest = 0;
    for (int a = node.first; a < node.last; ++a) {
      const long long t = plan.nodes[plan.neighbours[a].node].size;
      rest += t;
      count += t * s * s + 2 * t * s + t * s * rest;  // L, both substitutions, the update
    }
  }
  return count;
}

}  // namespace

bool has_no_loops(const Graph& graph) {
  std::vector<int> parent(graph.bodies + 1);  // the last stands for all that does not move
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int body) {
    if (body == Edge::no_body) body = graph.bodies;
    while (parent[body] != body) body = parent[body] = parent[parent[body]];
    return body;
  };
  for (const Edge& edge : graph.edges) {
    if (edge.inert()) continue;
    const int one = root(edge.body1), other = root(edge.body2);
    if (one == other) return false;
    parent[one] = other;
  }
  return true;
}

std::vector<int> coloured_order(const Graph& graph) {
  const auto edges = edges_of_bodies(graph);
  const int count = static_cast<int>(graph.edges.size());
  std::vector<int> colour(count, -1);
  int colours = 0;
  for (int e = 0; e < count; ++e) {
    std::vector<char> taken(colours + 1, 0);
    for (const int body : {graph.edges[e].body1, graph.edges[e].body2})
      if (body != Edge::no_body)
        for (const int other : edges[body])
          if (colour[other] >= 0) taken[colour[other]] = 1;
    colour[e] = static_cast<int>(std::find(taken.begin(), taken.end(), 0) - taken.begin());
    colours = std::max(colours, colour[e] + 1);
  }
  std::vector<int> order(count);
  for (int e = 0; e < count; ++e) order[e] = e;
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return colour[a] < colour[b]; });
  return order;
}

Elimination plan_elimination(const Graph& graph, int dof) {
  const auto edges = edges_of_bodies(graph);
  Elimination plan;
  plan.folded.resize(graph.bodies);
  for (int body = 0; body < graph.bodies; ++body) plan.folded[body] = edges[body].size() <= largest_folded;

  // Nodes of the game: the edges that can move something, then the hubs.
  std::vector<int> edge_of, hub_of, node_of_edge(graph.edges.size(), -1), node_of_hub(graph.bodies, -1);
  for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e) {
    if (graph.edges[e].inert()) continue;
    node_of_edge[e] = static_cast<int>(edge_of.size());
    edge_of.push_back(e);
  }
  const int edge_nodes = static_cast<int>(edge_of.size());
  for (int body = 0; body < graph.bodies; ++body)
    if (!plan.folded[body]) {
      node_of_hub[body] = edge_nodes + static_cast<int>(hub_of.size());
      hub_of.push_back(body);
    }

  struct Meeting {
    int a, b, side_a, side_b;
  };
  std::vector<Meeting> meetings;
  const auto side = [&](int edge, int body) { return graph.edges[edge].body2 == body ? 1 : 0; };
  for (int body = 0; body < graph.bodies; ++body)
    for (std::size_t i = 0; i < edges[body].size(); ++i) {
      const int e = edges[body][i];
      if (!plan.folded[body])
        meetings.push_back({node_of_edge[e], node_of_hub[body], side(e, body), 0});
      else
        for (std::size_t j = i + 1; j < edges[body].size(); ++j)
          meetings.push_back(
              {node_of_edge[e], node_of_edge[edges[body][j]], side(e, body), side(edges[body][j], body)});
    }

  const int count = edge_nodes + static_cast<int>(hub_of.size());
  Game game(count);
  for (const Meeting& meeting : meetings) game.join(meeting.a, meeting.b);
  if (!hub_of.empty()) {
    const auto served = with_own_body(graph, edges, plan.folded);
    for (int node = 0; node < edge_nodes; ++node)
      if (!served[edge_of[node]]) game.let_wait(node);
  }
  game.start();
  std::vector<int> sequence, place(count);
  while (static_cast<int>(sequence.size()) < count) {
    if (game.over())  // the hubs are gone, and what is left of A is whole
      for (int node = 0; node < edge_nodes; ++node) game.release(node);
    const int node = game.eliminate();
    place[node] = static_cast<int>(sequence.size());
    sequence.push_back(node);
    if (node >= edge_nodes)
      for (const int e : edges[hub_of[node - edge_nodes]])
        if (game.release(node_of_edge[e])) break;  // the hub is now a body of its own for one of them
  }

  const auto take = [&](int rows, int columns) {
    const int at = plan.values;
    plan.values += rows * columns;
    return at;
  };
  for (const int node : sequence) {
    Elimination::Node& to = plan.nodes.emplace_back();
    if (node < edge_nodes) {
      to.edge = edge_of[node];
      to.size = graph.edges[to.edge].rows;
      plan.order.push_back(to.edge);
    } else {
      to.hub = hub_of[node - edge_nodes];
      to.size = dof;
    }
    to.row = plan.unknowns;
    plan.unknowns += to.size;
  }
  for (std::size_t p = 0; p < sequence.size(); ++p) {
    Elimination::Node& node = plan.nodes[p];
    node.diagonal = take(node.size, node.size);
    std::vector<int> later;
    for (const int other : game.later(sequence[p])) later.push_back(place[other]);
    std::sort(later.begin(), later.end());
    node.first = static_cast<int>(plan.neighbours.size());
    for (const int other : later) plan.neighbours.push_back({other, take(plan.nodes[other].size, node.size), 0});
    node.last = static_cast<int>(plan.neighbours.size());
  }

  const auto block_between = [&](int earlier, int later) {
    const auto& node = plan.nodes[earlier];
    if (earlier == later) return node.diagonal;
    const auto first = plan.neighbours.begin() + node.first, last = plan.neighbours.begin() + node.last;
    return std::lower_bound(first, last, later, [](const auto& n, int wanted) { return n.node < wanted; })->block;
  };
  for (const auto& node : plan.nodes)
    for (int a = node.first; a < node.last; ++a) {
      plan.neighbours[a].targets = static_cast<int>(plan.targets.size());
      for (int b = a; b < node.last; ++b)
        plan.targets.push_back(block_between(plan.neighbours[a].node, plan.neighbours[b].node));
    }
  for (const Meeting& meeting : meetings) {
    const int a = place[meeting.a], b = place[meeting.b];
    if (a < b)
      plan.couplings.push_back({a, b, block_between(a, b), meeting.side_a, meeting.side_b});
    else
      plan.couplings.push_back({b, a, block_between(b, a), meeting.side_b, meeting.side_a});
  }
  std::sort(plan.couplings.begin(), plan.couplings.end(),
            [](const auto& x, const auto& y) { return x.block < y.block; });
  std::set<int> met;
  for (auto& coupling : plan.couplings) coupling.adds = !met.insert(coupling.block).second;
  for (const auto& node : plan.nodes)
    for (int a = node.first; a < node.last; ++a)
      if (!met.contains(plan.neighbours[a].block))
        plan.fill_in.push_back({plan.neighbours[a].block, plan.nodes[plan.neighbours[a].node].size * node.size});
  plan.multiplications = multiplications(plan);

  for (int e = 0; e < static_cast<int>(graph.edges.size()); ++e)
    if (graph.edges[e].inert()) plan.order.push_back(e);
  return plan;
}

}  // namespace byhand
