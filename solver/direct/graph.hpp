#pragma once

#include <vector>

namespace byhand {

/// A constraint as the order of solving sees it: the moving bodies it joins and how many rows it has. A body
/// that does not move passes nothing on and is left out as `no_body`.
struct Edge {
  static constexpr int no_body = -1;
  int body1 = no_body, body2 = no_body;
  int rows = 1;

  bool inert() const { return body1 == no_body && body2 == no_body; }
};

/// The bodies of a scene as points, its constraints as the edges between them, in the order in which they
/// were added.
struct Graph {
  int bodies = 0;
  std::vector<Edge> edges;
};

/// Whether no two ways lead from one body to another, what does not move counting as one body. Then the rows are
/// independent wherever each constraint's own are.
bool has_no_loops(const Graph& graph);

/// Edge numbers such that those of one colour share no moving body and stand together: a greedy colouring in
/// natural order, colour by colour. A chain comes out red–black.
std::vector<int> coloured_order(const Graph& graph);

/// The plan of a sparse block elimination: all that depends on the graph alone, and is kept while the graph
/// stays.
///
/// The unknowns are nodes: each edge's λ, and the change of velocity of each hub, a body that many edges
/// share. Nodes stand in the order in which they are eliminated. The matrix and then its factor L are blocks
/// in one array of numbers, row-major, each (size of the later node) × (size of the earlier one).
struct Elimination {
  struct Node {
    int edge = -1;            // its number in the graph, or -1 for a hub
    int hub = Edge::no_body;  // the hub's body
    int size = 0;             // rows of the edge, or degrees of freedom of the hub
    int diagonal = 0;         // where its own block stands
    int row = 0;              // where its unknowns stand, edges and hubs together
    int first = 0, last = 0;  // its later neighbours: a range of `neighbours`
  };
  struct Neighbour {
    int node = 0;     // eliminated later
    int block = 0;    // where the block between the two stands
    int targets = 0;  // in `targets`: where the products with this and each following neighbour are subtracted
  };
  /// Two edges that meet in a folded body, or an edge at a hub: where their entry comes from before
  /// elimination. `side` is 0 where the body is the edge's first, 1 where it is its second.
  struct Coupling {
    int earlier = 0, later = 0;
    int block = 0;
    int earlier_side = 0, later_side = 0;
    bool adds = false;  // the same two edges have met before, in another body
  };

  std::vector<Node> nodes;
  std::vector<Neighbour> neighbours;
  std::vector<int> targets;
  std::vector<Coupling> couplings;
  struct Range {
    int first, count;
  };
  std::vector<Range> fill_in;     // blocks that begin as zero
  std::vector<int> order;         // edge numbers as they are eliminated; edges between fixed bodies come last
  std::vector<char> folded;       // by body: whether it is folded into A = JM⁻¹Jᵀ
  int values = 0;                 // how many numbers all blocks hold
  int unknowns = 0;               // how many rows all nodes have
  long long multiplications = 0;  // of one factorisation with one solve
};

/// Plans by minimum degree with first-in-first-out ties, which takes a chain from both ends. A body with at
/// most three edges is folded into A; with more it would make a clique of them, and stays an unknown. Before
/// the hubs have gone A lacks their share, and is definite only among edges that have a body each, folded or
/// eliminated: the others wait. `dof` is the size of a hub.
Elimination plan_elimination(const Graph& graph, int dof);

}  // namespace byhand
