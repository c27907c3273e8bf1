// SPDX-License-Identifier: GPL-3.0-or-later

#include "strainDomains.H"
#include "EdgeMap.H"

#include <algorithm>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::fsi::strainDomains::domainOfCorners
(
    const shapeMesh& mesh,
    const kind domainKind
)
{
    labelList domains(3*mesh.elements.size());
    EdgeMap<label> edges;
    if (domainKind == kind::edge)
    {
        for (const edge& e : mesh.edges())
        {
            edges.insert(e, edges.size());
        }
    }
    forAll(mesh.elements, elementi)
    {
        const bodyElement& element = mesh.elements[elementi];
        for (label i = 0; i < 3; ++i)
        {
            domains[3*elementi + i] =
                domainKind == kind::node ? element[i]
              : domainKind == kind::triangle ? elementi
              : edges[edge(element[i], element[(i + 1) % 3])];
        }
    }
    return domains;
}


void Foam::fsi::strainDomains::append
(
    const shapeMesh& mesh,
    const labelList& triangles
)
{
    // Area of the triangles, and its gradients by their nodes
    scalar area = 0;
    std::vector<label> nodes;
    std::vector<vector> gradients;
    for (const label trianglei : triangles)
    {
        const bodyElement& element = mesh.elements[trianglei];
        for (label i = 0; i < 3; ++i)
        {
            const point& next = mesh.points[element[(i + 1) % 3]];
            const point& last = mesh.points[element[(i + 2) % 3]];
            const point& own = mesh.points[element[i]];
            area += (own.x()*next.y() - own.y()*next.x())/2;

            auto found = std::find(nodes.begin(), nodes.end(), element[i]);
            const std::size_t place = found - nodes.begin();
            if (found == nodes.end())
            {
                nodes.push_back(element[i]);
                gradients.push_back(Zero);
            }
            gradients[place] +=
                0.5*vector(next.y() - last.y(), last.x() - next.x(), 0);
        }
    }

    for (std::size_t i = 0; i < nodes.size(); ++i)
    {
        nodes_.append(nodes[i]);
        const vector offset = mesh.points[nodes[i]] - mesh.points[nodes[0]];
        offsets_.append(offset.x());
        offsets_.append(offset.y());
        gradients_.append(gradients[i].x()/area);
        gradients_.append(gradients[i].y()/area);
    }
    start_.append(nodes_.size());
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::strainDomains::strainDomains
(
    const shapeMesh& mesh,
    const scalar thickness,
    const kind domainKind
)
:
    start_(1, label(0))
{
    // A triangle for itself has one part, else three of the same size
    const label nParts = domainKind == kind::triangle ? 1 : 3;
    const labelList domains(domainOfCorners(mesh, domainKind));
    const label n =
        domains.empty()
      ? 0 : *std::max_element(domains.begin(), domains.end()) + 1;
    const scalarField areas(mesh.elementVolumes());

    List<DynamicList<label>> triangles(n);
    volumes_ = scalarField(n, Zero);
    forAll(areas, trianglei)
    {
        for (label i = 0; i < nParts; ++i)
        {
            const label domaini = domains[3*trianglei + i];
            triangles[domaini].append(trianglei);
            volumes_[domaini] += areas[trianglei]*thickness/nParts;
        }
    }
    for (const labelList& trianglesOfDomain : triangles)
    {
        append(mesh, trianglesOfDomain);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::strainDomains::gradient
(
    const label domaini,
    const Eigen::Ref<const Eigen::MatrixXd>& x,
    const bool atRest,
    scalar (&F)[4]
) const
{
    const label origin = nodes_[start_[domaini]];
    std::fill(F, F + 4, 0);
    for (label j = start_[domaini] + 1; j < start_[domaini + 1]; ++j)
    {
        for (int i = 0; i < 2; ++i)
        {
            const scalar d =
                x(nodes_[j], i) - x(origin, i)
              - (atRest ? offsets_[2*j + i] : 0);
            F[2*i] += d*gradients_[2*j];
            F[2*i + 1] += d*gradients_[2*j + 1];
        }
    }
}


void Foam::fsi::strainDomains::addForce
(
    const label domaini,
    const scalar (&P)[4],
    Eigen::Ref<Eigen::MatrixXd> force
) const
{
    const label origin = nodes_[start_[domaini]];
    for (label j = start_[domaini] + 1; j < start_[domaini + 1]; ++j)
    {
        for (int i = 0; i < 2; ++i)
        {
            const scalar f =
                P[2*i]*gradients_[2*j] + P[2*i + 1]*gradients_[2*j + 1];
            force(nodes_[j], i) -= f;
            force(origin, i) += f;
        }
    }
}


void Foam::fsi::strainDomains::addLaplacian
(
    const scalar weight,
    std::vector<Eigen::Triplet<double>>& entries
) const
{
    if (weight == 0)
    {
        return;
    }
    forAll(volumes_, domaini)
    {
        for (label i = start_[domaini]; i < start_[domaini + 1]; ++i)
        {
            for (label j = start_[domaini]; j < start_[domaini + 1]; ++j)
            {
                const scalar product =
                    gradients_[2*i]*gradients_[2*j]
                  + gradients_[2*i + 1]*gradients_[2*j + 1];
                entries.emplace_back
                (
                    nodes_[i],
                    nodes_[j],
                    weight*volumes_[domaini]*product
                );
            }
        }
    }
}


// ************************************************************************* //
