// SPDX-FileCopyrightText: Copyright (c) 2026 The EvolvingSurfaces authors
// SPDX-License-Identifier: BSD-3-Clause

#include "CGALPeer.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/detect_features.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/remesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/alpha_wrap_3.h>
#include <CGAL/version.h>

#include <array>
#include <vector>

namespace benchmark
{

namespace
{

namespace PMP = CGAL::Polygon_mesh_processing;

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Corners = std::array<std::size_t, 3>;
using EdgeFlags = Mesh::Property_map<Mesh::Edge_index, bool>;

constexpr unsigned int Iterations = 3;

EdgeFlags sharpEdges(Mesh& mesh, double featureAngle)
{
  const EdgeFlags isSharp = mesh.add_property_map<Mesh::Edge_index, bool>("e:sharp", false).first;
  if (featureAngle > 0.0)
  {
    PMP::detect_sharp_edges(mesh, featureAngle, isSharp);
  }
  return isSharp;
}

} // namespace

struct CGALPeer::Parts
{
  std::vector<Point> Points;
  std::vector<Corners> Triangles;
  bool IsMesh = false;
  Mesh Input; ///< empty unless IsMesh
  Mesh Result;
};

std::string CGALPeer::version()
{
  return std::string("CGAL ") + CGAL_VERSION_STR;
}

CGALPeer::CGALPeer(const evolving::SurfaceMesh& input)
  : Own(std::make_unique<Parts>())
{
  for (const evolving::Vec3& point : input.points)
  {
    this->Own->Points.emplace_back(point.x(), point.y(), point.z());
  }
  for (evolving::Index f = 0; f < input.faceCount(); ++f)
  {
    Corners corners;
    for (std::size_t k = 0; k < 3; ++k)
    {
      corners[k] = static_cast<std::size_t>(input.faceVertex(f, static_cast<evolving::Index>(k)));
    }
    this->Own->Triangles.push_back(corners);
  }
  this->Own->IsMesh =
    !this->Own->Triangles.empty() && PMP::is_polygon_soup_a_polygon_mesh(this->Own->Triangles);
  if (this->Own->IsMesh)
  {
    PMP::polygon_soup_to_polygon_mesh(this->Own->Points, this->Own->Triangles, this->Own->Input);
  }
}

CGALPeer::~CGALPeer() = default;

bool CGALPeer::canRemesh() const
{
  return this->Own->IsMesh;
}

void CGALPeer::wrap(double alpha, double offset)
{
  this->Own->Result.clear();
  if (this->Own->Triangles.empty())
  {
    CGAL::alpha_wrap_3(this->Own->Points, alpha, offset, this->Own->Result);
  }
  else
  {
    CGAL::alpha_wrap_3(this->Own->Points, this->Own->Triangles, alpha, offset, this->Own->Result);
  }
}

void CGALPeer::remesh(double edgeLength, double featureAngle)
{
  Mesh& mesh = this->Own->Result;
  mesh = this->Own->Input;
  PMP::isotropic_remeshing(mesh.faces(), edgeLength, mesh,
    CGAL::parameters::number_of_iterations(Iterations)
      .edge_is_constrained_map(sharpEdges(mesh, featureAngle)));
}

evolving::SurfaceMesh CGALPeer::result() const
{
  Mesh mesh = this->Own->Result;
  mesh.collect_garbage(); // afterwards the numbers have no gaps
  evolving::SurfaceMesh result;
  for (const Mesh::Vertex_index v : mesh.vertices())
  {
    const Point& point = mesh.point(v);
    result.addPoint({ point.x(), point.y(), point.z() });
  }
  for (const Mesh::Face_index f : mesh.faces())
  {
    std::vector<evolving::Index> corners;
    for (const Mesh::Vertex_index v : vertices_around_face(mesh.halfedge(f), mesh))
    {
      corners.push_back(static_cast<evolving::Index>(v.idx()));
    }
    result.addFace(corners);
  }
  return result;
}

} // namespace benchmark
