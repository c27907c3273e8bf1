// SPDX-License-Identifier: GPL-3.0-or-later

#include "strainDomains.H"
#include "EdgeMap.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- A corner's part in the area or volume of an element
static scalar volumeShare
(
    const shapeMesh& mesh,
    const bodyElement& element,
    const label i
)
{
    const point& own = mesh.points[element[i]];
    if (element[3] < 0)
    {
        const point& next = mesh.points[element[(i + 1) % 3]];
        return (own.x()*next.y() - own.y()*next.x())/2;
    }
    return (own & strainDomains::volumeGradient(mesh, element, i))/3;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::fsi::strainDomains::domainOfParts
(
    const shapeMesh& mesh,
    const kind domainKind,
    const label nCorners
)
{
    EdgeMap<label> edges;
    if (domainKind == kind::edge)
    {
        for (const edge& e : mesh.edges())
        {
            edges.insert(e, edges.size());
        }
    }

    DynamicList<label> domains;
    forAll(mesh.elements, elementi)
    {
        const bodyElement& element = mesh.elements[elementi];
        if (domainKind == kind::element)
        {
            domains.append(elementi);
        }
        for (label i = 0; i < nCorners; ++i)
        {
            if (domainKind == kind::node)
            {
                domains.append(element[i]);
            }
            for (label j = i + 1; domainKind == kind::edge && j < nCorners; ++j)
            {
                domains.append(edges[edge(element[i], element[j])]);
            }
        }
    }
    return domains;
}


void Foam::fsi::strainDomains::append
(
    const shapeMesh& mesh,
    const labelList& elements
)
{
    // Area or volume of the elements, and its gradients by their nodes
    scalar volume = 0;
    std::vector<label> nodes;
    std::vector<vector> gradients;
    for (const label elementi : elements)
    {
        const bodyElement& element = mesh.elements[elementi];
        for (label i = 0; i < nDims_ + 1; ++i)
        {
            volume += volumeShare(mesh, element, i);

            auto found = std::find(nodes.begin(), nodes.end(), element[i]);
            const std::size_t place = found - nodes.begin();
            if (found == nodes.end())
            {
                nodes.push_back(element[i]);
                gradients.push_back(Zero);
            }
            gradients[place] += volumeGradient(mesh, element, i);
        }
    }

    for (std::size_t n = 0; n < nodes.size(); ++n)
    {
        nodes_.append(nodes[n]);
        const vector offset = mesh.points[nodes[n]] - mesh.points[nodes[0]];
        for (label i = 0; i < nDims_; ++i)
        {
            offsets_.append(offset[i]);
            gradients_.append(gradients[n][i]/volume);
        }
    }
    start_.append(nodes_.size());
}


template<class Product>
void Foam::fsi::strainDomains::addProducts
(
    const Product& product,
    matrixEntries& entries
) const
{
    forAll(volumes_, domaini)
    {
        for (label m = start_[domaini]; m < start_[domaini + 1]; ++m)
        {
            for (label n = start_[domaini]; n < start_[domaini + 1]; ++n)
            {
                entries.emplace_back
                (
                    nodes_[m],
                    nodes_[n],
                    volumes_[domaini]
                   *product(&gradients_[nDims_*m], &gradients_[nDims_*n])
                );
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::strainDomains::strainDomains
(
    const shapeMesh& mesh,
    const scalar thickness,
    const kind domainKind
)
:
    nDims_(mesh.nDims()),
    start_(1, label(0))
{
    const labelList domains(domainOfParts(mesh, domainKind, nDims_ + 1));
    const scalarField volumes(mesh.elementVolumes());
    const label nParts = domains.size()/max(volumes.size(), 1);
    const label n =
        domains.empty()
      ? 0 : *std::max_element(domains.begin(), domains.end()) + 1;

    List<DynamicList<label>> elements(n);
    volumes_ = scalarField(n, Zero);
    forAll(domains, parti)
    {
        const label elementi = parti/nParts;
        elements[domains[parti]].append(elementi);
        volumes_[domains[parti]] += volumes[elementi]*thickness/nParts;
    }
    for (const labelList& elementsOfDomain : elements)
    {
        append(mesh, elementsOfDomain);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::vector Foam::fsi::strainDomains::volumeGradient
(
    const shapeMesh& mesh,
    const bodyElement& element,
    const label i
)
{
    if (element[3] < 0)
    {
        const point& next = mesh.points[element[(i + 1) % 3]];
        const point& last = mesh.points[element[(i + 2) % 3]];
        return 0.5*vector(next.y() - last.y(), last.x() - next.x(), 0);
    }

    // The other three, counter-clockwise seen from this one
    static const label others[4][3] =
        {{1, 3, 2}, {0, 2, 3}, {1, 0, 3}, {0, 1, 2}};
    const point& a = mesh.points[element[others[i][0]]];
    const vector b = mesh.points[element[others[i][1]]] - a;
    const vector c = mesh.points[element[others[i][2]]] - a;
    return (b ^ c)/6;
}


void Foam::fsi::strainDomains::gradient
(
    const label domaini,
    const Eigen::Ref<const Eigen::MatrixXd>& x,
    const bool atRest,
    scalar* F
) const
{
    const label origin = nodes_[start_[domaini]];
    std::fill(F, F + nDims_*nDims_, 0);
    for (label n = start_[domaini] + 1; n < start_[domaini + 1]; ++n)
    {
        for (label i = 0; i < nDims_; ++i)
        {
            const scalar d =
                x(nodes_[n], i) - x(origin, i)
              - (atRest ? offsets_[nDims_*n + i] : 0);
            for (label j = 0; j < nDims_; ++j)
            {
                F[nDims_*i + j] += d*gradients_[nDims_*n + j];
            }
        }
    }
}


void Foam::fsi::strainDomains::addForce
(
    const label domaini,
    const scalar* P,
    Eigen::Ref<Eigen::MatrixXd> force
) const
{
    const label origin = nodes_[start_[domaini]];
    for (label n = start_[domaini] + 1; n < start_[domaini + 1]; ++n)
    {
        for (label i = 0; i < nDims_; ++i)
        {
            scalar f = 0;
            for (label j = 0; j < nDims_; ++j)
            {
                f += P[nDims_*i + j]*gradients_[nDims_*n + j];
            }
            force(nodes_[n], i) -= f;
            force(origin, i) += f;
        }
    }
}


void Foam::fsi::strainDomains::addLaplacian
(
    const scalar weight,
    matrixEntries& entries
) const
{
    if (weight == 0)
    {
        return;
    }
    addProducts
    (
        [&](const scalar* gm, const scalar* gn)
        {
            scalar product = 0;
            for (label i = 0; i < nDims_; ++i)
            {
                product += gm[i]*gn[i];
            }
            return weight*product;
        },
        entries
    );
}


void Foam::fsi::strainDomains::addCurl(matrixEntries& entries) const
{
    addProducts
    (
        [](const scalar* gm, const scalar* gn)
        {
            return gn[0]*gm[1] - gn[1]*gm[0];
        },
        entries
    );
}


// ************************************************************************* //
