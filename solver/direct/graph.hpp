#pragma once

#include <vector>

#include "solver/rows/row_solver.hpp"

namespace byhand {

/// A constraint as an edge between bodies. A fixed body transmits no impulse and is `no_body`.
struct Edge {
  static constexpr int no_body = -1;
  int body1 = no_body, body2 = no_body;
  int rows = 1;

  bool inert() const { return body1 == no_body && body2 == no_body; }
};

/// The bodies of a scene as vertices and its constraints as edges, in the order in which they were added.
struct Graph {
  int bodies = 0;
  std::vector<Edge> edges;
  bool bounded = false;  // whether any row has a bound
};

/// The rows of all edges.
int row_count(const Graph& graph);

/// Whether the graph is a forest, with all fixed bodies as one vertex. Then the rows of different constraints are
/// independent.
bool has_no_loops(const Graph& graph);

/// Edge numbers sorted by colour, where edges of one colour share no moving body: a greedy colouring in natural
/// order. A chain becomes red–black.
std::vector<int> coloured_order(const Graph& graph);

/// Edge numbers as they were added, reversed, or sorted by colour.
std::vector<int> natural_order(int edges);
std::vector<int> order_of(Layout layout, const Graph& graph);

/// The plan of a sparse block elimination, which depends on the graph alone.
///
/// The unknowns are nodes in order of elimination: each edge's λ, and the change of velocity of each hub, a body
/// with many edges. The matrix, and later its factor L, consists of row-major blocks in one array of numbers, each
/// of (size of the later node) × (size of the earlier one).
struct Elimination {
  struct Node {
    int edge = -1;            // its place in `order`, or -1 for a hub
    int hub = Edge::no_body;  // the hub's body
    int size = 0;             // rows of the edge, or degrees of freedom of the hub
    int diagonal = 0;         // offset of its diagonal block
    int row = 0;              // of its first unknown, edges and hubs counted together
    int lambda = 0;           // of an edge: its first row in λ
    int root = 0;             // the node of its connected part that is eliminated last
    int first = 0, last = 0;  // its neighbours that are eliminated later: a range of `neighbours`
  };
  struct Neighbour {
    int node = 0;
    int block = 0;    // offset of the block between the two
    int targets = 0;  // in `targets`: offsets of the blocks that this and each following neighbour update
  };
  /// A term of a block before elimination: two edges at a folded body, or an edge at a hub.
  struct Coupling {
    struct End {
      int node, side;  // 0 where the body is the edge's first, 1 where it is its second
    };
    End earlier, later;
    int block = 0;
    bool adds = false;  // to another term
  };
  struct Range {
    int first, count;
  };

  std::vector<Node> nodes;
  std::vector<Neighbour> neighbours;
  std::vector<int> targets;
  std::vector<Coupling> couplings;
  std::vector<Range> fill_in;    // blocks that are zero before elimination
  std::vector<int> order;        // edge numbers in order of elimination, then the inert edges
  std::vector<char> folded;      // by body: whether its mass is part of A = JM⁻¹Jᵀ, as for all but hubs
  int edge_size = 0;             // the rows of every edge, 0 where they differ
  int edge_rows = 0;             // the rows of all edges but the inert ones
  int values = 0, unknowns = 0;  // the count of numbers in all blocks, of rows of all nodes
  long long multiplications = 0, multiplications_again = 0;  // to factor and solve; to solve again
  long long planned = 0;  // work of this planning, counted in numbers read from its lists
};

/// Plans by minimum degree with first-in-first-out ties, which takes a chain from both ends. A body with at most
/// three edges, or eight where the graph has loops, is folded into A; one with more would make a clique of them,
/// and becomes a hub. As long as hubs are left, A is definite only among edges that each have a body of their own,
/// folded or eliminated: the others are deferred, and a mesh of hubs would fill up. `dof` is the size of a hub.
/// Gives up once it counts more than so many `multiplications`; nothing else of such a plan is of use.
Elimination plan_elimination(const Graph& graph, int dof, long long most);

/// The multiplications that a direct solve may take in a step.
inline long long most_multiplications(const Graph& graph) { return (1 << 25) + 500LL * row_count(graph); }

/// Places of constraints in the order of elimination, whose `plan` it writes. Throws std::invalid_argument where a
/// direct solve would take too long, which no chain, tree or sheet of 100 × 100 does.
std::vector<int> elimination_order(const Graph& graph, int dof, Elimination& plan);

}  // namespace byhand
