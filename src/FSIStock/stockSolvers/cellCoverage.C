// SPDX-License-Identifier: GPL-3.0-or-later

#include "cellCoverage.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Linear shape functions of a triangle (2D, corners in x and y) or of a
//  tetrahedron at p; those of corners that are not there are 0
static FixedList<scalar, 4> shapeFunctions
(
    const FixedList<point, 4>& corners,
    const direction nDims,
    const point& p
)
{
    const vector a(corners[1] - corners[0]);
    const vector b(corners[2] - corners[0]);
    const vector c(nDims == 2 ? vector(0, 0, 1) : corners[3] - corners[0]);
    const vector r(p - corners[0]);
    const scalar volume = (a ^ b) & c;

    FixedList<scalar, 4> n;
    n[1] = ((r ^ b) & c)/volume;
    n[2] = ((a ^ r) & c)/volume;
    n[3] = nDims == 2 ? 0 : ((a ^ b) & r)/volume;
    n[0] = 1 - n[1] - n[2] - n[3];
    return n;
}


//- True if a point with these shape functions is in the element; a point on
//  the side of two elements is in both
static bool inside(const FixedList<scalar, 4>& weights)
{
    for (const scalar w : weights)
    {
        if (w < -1e-10)
        {
            return false;
        }
    }
    return true;
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::cellCoverage::cellCoverage
(
    const cartesianMesh& grid,
    const label nSamples
)
:
    grid_(grid),
    nSamples_(nSamples),
    slot_(grid.mesh().nCells(), -1)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::fsi::cellCoverage::findSlot(const label celli)
{
    if (slot_[celli] < 0)
    {
        slot_[celli] = cells_.size();
        cells_.append(celli);
        count_.append(0);
    }
    return slot_[celli];
}


void Foam::fsi::cellCoverage::addSample
(
    const point& p,
    const FixedList<scalar, 4>& weights,
    const coveredPart& part,
    const label firstPart
)
{
    const label celli = grid_.findCell(p);
    if (celli < 0)
    {
        return;
    }
    const label slot = findSlot(celli);
    count_[slot] += 1;

    label parti = firstPart;
    while (parti < parts_.size() && parts_[parti].slot != slot)
    {
        ++parti;
    }
    if (parti == parts_.size())
    {
        parts_.append(part);
        parts_[parti].slot = slot;
    }
    forAll(weights, i)
    {
        parts_[parti].weights[i] += weights[i];
    }
}


void Foam::fsi::cellCoverage::addElement
(
    const bodyGroup& group,
    const label groupi,
    const label copyi,
    const FixedList<label, 4>& nodes
)
{
    const direction nDims = grid_.nDims();
    const boundBox domain(grid_.bounds());
    const scalar step = grid_.spacing()/nSamples_;

    FixedList<point, 4> corners(domain.midpoint());
    labelVector first(0, 0, 0);
    labelVector last(0, 0, 0);
    for (direction d = 0; d < nDims; ++d)
    {
        for (direction i = 0; i <= nDims; ++i)
        {
            corners[i][d] = group.positions()(nodes[i], nDims*copyi + d);
        }
        scalar lowest = corners[0][d];
        scalar highest = lowest;
        for (direction i = 1; i <= nDims; ++i)
        {
            lowest = min(lowest, corners[i][d]);
            highest = max(highest, corners[i][d]);
        }
        first[d] = label(floor((lowest - domain.min()[d])/step));
        last[d] = label(ceil((highest - domain.min()[d])/step));
    }

    coveredPart part;
    part.group = groupi;
    part.copy = copyi;
    part.nodes = nodes;
    part.weights = scalar(0);

    const label firstPart = parts_.size();
    labelVector ijk;
    for (ijk[2] = first[2]; ijk[2] <= last[2]; ++ijk[2])
    {
        for (ijk[1] = first[1]; ijk[1] <= last[1]; ++ijk[1])
        {
            for (ijk[0] = first[0]; ijk[0] <= last[0]; ++ijk[0])
            {
                point p(domain.midpoint());
                for (direction d = 0; d < nDims; ++d)
                {
                    p[d] = domain.min()[d] + (ijk[d] + 0.5)*step;
                }
                const auto weights = shapeFunctions(corners, nDims, p);
                if (inside(weights))
                {
                    addSample(p, weights, part, firstPart);
                }
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::cellCoverage::update(const population& objects)
{
    for (const label celli : cells_)
    {
        slot_[celli] = -1;
    }
    cells_.clear();
    count_.clear();
    parts_.clear();

    forAll(objects.groups(), groupi)
    {
        const bodyGroup& group = objects.groups()[groupi];
        if (group.shape().elements().empty())
        {
            FatalErrorInFunction
                << "Shape " << group.shape().name() << " has no elements"
                << " inside, as rigid ones: fsiPisoFoam knows such objects, the"
                << " stock solvers do not" << exit(FatalError);
        }
        for (label copyi = 0; copyi < group.size(); ++copyi)
        {
            for (const bodyElement& element : group.shape().elements())
            {
                addElement(group, groupi, copyi, element);
            }
        }
    }
}


Foam::tmp<Foam::scalarField> Foam::fsi::cellCoverage::fractions() const
{
    const scalar perCell = pow(scalar(nSamples_), label(grid_.nDims()));
    auto tfractions = newTmp<scalarField>(count_);
    tfractions.ref() = min(tfractions()/perCell, scalar(1));
    return tfractions;
}


Foam::tmp<Foam::vectorField> Foam::fsi::cellCoverage::interpolate
(
    const List<Eigen::MatrixXd>& nodal
) const
{
    const direction nDims = grid_.nDims();
    auto tvalues = newTmp<vectorField>(cells_.size(), Zero);
    vectorField& values = tvalues.ref();
    for (const coveredPart& part : parts_)
    {
        const Eigen::MatrixXd& nodes = nodal[part.group];
        for (direction i = 0; i <= nDims; ++i)
        {
            const scalar w = part.weights[i]/count_[part.slot];
            for (direction d = 0; d < nDims; ++d)
            {
                values[part.slot][d] +=
                    w*nodes(part.nodes[i], nDims*part.copy + d);
            }
        }
    }
    return tvalues;
}


void Foam::fsi::cellCoverage::spread
(
    const vectorField& values,
    List<Eigen::MatrixXd>& nodal
) const
{
    const direction nDims = grid_.nDims();
    for (const coveredPart& part : parts_)
    {
        Eigen::MatrixXd& nodes = nodal[part.group];
        for (direction i = 0; i <= nDims; ++i)
        {
            const scalar w = part.weights[i]/count_[part.slot];
            for (direction d = 0; d < nDims; ++d)
            {
                nodes(part.nodes[i], nDims*part.copy + d) +=
                    w*values[part.slot][d];
            }
        }
    }
}


// ************************************************************************* //
