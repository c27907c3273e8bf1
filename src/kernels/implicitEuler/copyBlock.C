// SPDX-License-Identifier: GPL-3.0-or-later

#include "copyBlock.H"
#include "laneReference.H"
#include "stepMatrix.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::copyBlock::copyBlock(const shapeTemplate& shape)
:
    shape_(shape),
    nDims(shape.nDims())
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::copyBlock::pullHeld
(
    const copyState& s,
    const label copyi,
    const int lane,
    const int lanes
)
{
    const labelList& nodes = shape_.held().nodes();
    for (label k = 0; k < nodes.size(); ++k)
    {
        const label row = rowOf_[nodes[k]];
        const scalar m = shape_.nodeMasses()[nodes[k]];
        for (label i = 0; i < nDims; ++i)
        {
            const label column = nDims*(copyi + lane) + i;
            const label place = lanes*(nDims*row + i) + lane;
            const scalar free =
                change[place] + sqr(deltaT)*s.forces(nodes[k], column)/m;
            inertial[place] =
                (
                    m*free
                  + (masses[row] - m)*((*s.anchors)(k, column) - start[place])
                )/masses[row];
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::copyBlock::setFactor(const admmFactor& factor)
{
    deltaT = factor.deltaT();
    rowOf_ = factor.rowOf();
    masses.resize(shape_.nNodes());
    const scalarField own(stepMasses(shape_, deltaT));
    forAll(masses, nodei)
    {
        masses[rowOf_[nodei]] = own[nodei];
    }
}


void Foam::fsi::copyBlock::resize(const label lanes)
{
    const label n = nDims*lanes*shape_.nNodes();
    if (start.size() < n)
    {
        for
        (
            scalarField* field :
            {&start, &inertial, &displacement, &change, &residual}
        )
        {
            field->resize(n);
        }
        lessDrift.resize(shape_.viscosity() > 0 ? n : 0);
    }
}


template<int lanes>
void Foam::fsi::copyBlock::load(const copyState& s, const label copyi)
{
    for (int lane = 0; lane < lanes; ++lane)
    {
        for (label i = 0; i < nDims; ++i)
        {
            const label column = nDims*(copyi + lane) + i;
            const double* x = s.positions.col(column).data();
            const double* v = s.velocities.col(column).data();
            const double* f = s.forces.col(column).data();
            forAll(rowOf_, nodei)
            {
                const label row = rowOf_[nodei];
                const label place = lanes*(nDims*row + i) + lane;
                start[place] = x[nodei];
                displacement[place] = x[nodei] - shape_.points()[nodei][i];
                change[place] = deltaT*v[nodei];
                inertial[place] =
                    change[place] + sqr(deltaT)*f[nodei]/masses[row];
            }
        }
        if (s.anchors)
        {
            pullHeld(s, copyi, lane, lanes);
        }
    }
    forAll(lessDrift, place)
    {
        lessDrift[place] = -change[place];
    }
}


template<int lanes>
void Foam::fsi::copyBlock::restoreMomentum()
{
    for (label i = 0; i < nDims; ++i)
    {
        laneArray<lanes> missing = laneArray<lanes>::Zero();
        forAll(masses, row)
        {
            missing += masses[row]
               *(
                    at<lanes>(inertial, nDims*row + i)
                  - at<lanes>(change, nDims*row + i)
                );
        }
        missing /= sum(masses);
        forAll(masses, row)
        {
            to<lanes>(change, nDims*row + i) += missing;
        }
    }
}


template<int lanes>
void Foam::fsi::copyBlock::inertialResidual()
{
    forAll(masses, row)
    {
        for (label place = nDims*row; place < nDims*(row + 1); ++place)
        {
            to<lanes>(residual, place) = masses[row]
               *(at<lanes>(inertial, place) - at<lanes>(change, place));
        }
    }
}


template<int lanes>
void Foam::fsi::copyBlock::store(const label copyi, Eigen::MatrixXd& v) const
{
    for (int lane = 0; lane < lanes; ++lane)
    {
        for (label i = 0; i < nDims; ++i)
        {
            double* column = v.col(nDims*(copyi + lane) + i).data();
            forAll(rowOf_, nodei)
            {
                column[nodei] =
                    change[lanes*(nDims*rowOf_[nodei] + i) + lane]/deltaT;
            }
        }
    }
}


// * * * * * * * * * * * * * Explicit Instantiation  * * * * * * * * * * * * //

#define makeBlock(lanes)                                                       \
                                                                               \
    template void copyBlock::load<lanes>(const copyState&, const label);       \
    template void copyBlock::restoreMomentum<lanes>();                         \
    template void copyBlock::inertialResidual<lanes>();                        \
    template void copyBlock::store<lanes>(const label, Eigen::MatrixXd&) const;

namespace Foam
{
namespace fsi
{
    makeBlock(1)
    makeBlock(2)
    makeBlock(4)
    makeBlock(8)
}
}

#undef makeBlock

// ************************************************************************* //
