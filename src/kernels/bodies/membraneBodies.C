// SPDX-License-Identifier: GPL-3.0-or-later

#include "membraneBodies.H"
#include "errorOf.H"
#include "innerFlow.H"
#include "openfoamVersion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Write the node labels of the triangles of all copies
static void writeTriangles
(
    Ostream& os,
    const List<List<bodyElement>>& triangles
)
{
    DynamicList<label> labels;
    for (const List<bodyElement>& copy : triangles)
    {
        for (const bodyElement& triangle : copy)
        {
            for (label i = 0; i < 3; ++i)
            {
                labels.append(triangle[i]);
            }
        }
    }
    putList(os, "triangles", labelList(std::move(labels)));
}


//- Read them into lists of the sizes they have
static void readTriangles
(
    const dictionary& dict,
    const label nNodes,
    List<List<bodyElement>>& triangles
)
{
    const labelList labels(readEntry<labelList>(dict, "triangles"));
    label next = 0;
    for (List<bodyElement>& copy : triangles)
    {
        for (bodyElement& triangle : copy)
        {
            for (label i = 0; i < 3 && next < labels.size(); ++i)
            {
                triangle[i] = labels[next++];
            }
        }
    }
    const label expected =
        triangles.empty() ? 0 : 3*triangles.size()*triangles[0].size();
    if
    (
        labels.size() != expected
     || (expected && (min(labels) < 0 || max(labels) >= nNodes))
    )
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'triangles' in dictionary " << dict.name() << " has "
            << labels.size() << " values but must have " << expected
            << " labels of nodes" << exit(FatalIOError);
    }
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::membraneBodies::addInnerFriction(Eigen::MatrixXd& force) const
{
    const scalar viscosity =
        shape().membrane()->innerViscosity*shape().thickness();
    const label n = shape().nNodes();
    std::vector<Eigen::Triplet<double>> entries;
    forAll(triangles_, copyi)
    {
        entries.clear();
        innerFlow::addViscosity
        (
            triangles_[copyi], ofCopy(positions(), copyi), viscosity, 1, entries
        );
        const auto v = ofCopy(velocities(), copyi);
        auto f = ofCopy(force, copyi);
        for (const Eigen::Triplet<double>& e : entries)
        {
            f(e.row() % n, e.row()/n) -= e.value()*v(e.col() % n, e.col()/n);
        }
    }
}


// * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * * //

Foam::scalar Foam::fsi::membraneBodies::addTerms
(
    const label copyi,
    Eigen::MatrixXd* force
) const
{
    const auto x = ofCopy(positions(), copyi);
    if (force)
    {
        shape().bending().addForce(x, ofCopy(*force, copyi));
    }
    return shape().bending().energy(x);
}


void Foam::fsi::membraneBodies::resizeState(const label nCopies)
{
    deformableBodies::resizeState(nCopies);
    triangles_.resize(nCopies, shape().elements());
}


void Foam::fsi::membraneBodies::startState(const label copyi)
{
    deformableBodies::startState(copyi);
    triangles_[copyi] = shape().elements();
}


void Foam::fsi::membraneBodies::exchangeState
(
    const label copyi,
    copyValues& values
)
{
    deformableBodies::exchangeState(copyi, values);
    for (bodyElement& triangle : triangles_[copyi])
    {
        for (label i = 0; i < 3; ++i)
        {
            values.number(triangle[i]);
        }
    }
}


void Foam::fsi::membraneBodies::writeState(Ostream& os) const
{
    deformableBodies::writeState(os);
    writeTriangles(os, triangles_);
}


void Foam::fsi::membraneBodies::readState(const dictionary& dict)
{
    deformableBodies::readState(dict);
    readTriangles(dict, shape().nNodes(), triangles_);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::membraneBodies::membraneBodies(const shapeTemplate& shape)
:
    deformableBodies(shape, bodyFreedom(shape.nDims()))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::membraneBodies::predict
(
    const scalar,
    const scalar dt,
    const Eigen::MatrixXd& force,
    Eigen::MatrixXd& v
) const
{
    if (!response_.preparedFor(dt, positions()))
    {
        response_.prepare(dt, positions(), triangles_);
    }

    const Eigen::Map<const Eigen::VectorXd> masses
    (
        shape().nodeMasses().cdata(),
        shape().nNodes()
    );
    Eigen::MatrixXd total;
    internalForce(total);
    total += force;
    if (!secondOrder())
    {
        total += masses.asDiagonal()*velocities()/dt;
        response_.respondFreely(total, v);
        return;
    }

    // Linear about v*, with which nodes come to x*
    total += masses.asDiagonal()*(startVelocities() - velocities())/dt;
    addInnerFriction(total);
    response_.respondFreely(total, v);
    v += velocities();
}


void Foam::fsi::membraneBodies::prepareResponse(const scalar dt)
{
    response_.prepare(dt, positions(), triangles_);
}


void Foam::fsi::membraneBodies::move(const scalar dt, const Eigen::MatrixXd& v)
{
    deformableBodies::move(dt, v);
    forAll(triangles_, copyi)
    {
        innerFlow::renew
        (
            triangles_[copyi],
            ofCopy(positions(), copyi),
            shape().nBoundaryNodes()
        );
    }
}


Foam::scalar Foam::fsi::membraneBodies::innerDissipation
(
    const label copyi
) const
{
    return innerFlow::dissipation
    (
        triangles_[copyi],
        ofCopy(positions(), copyi),
        ofCopy(velocities(), copyi),
        shape().membrane()->innerViscosity*shape().thickness()
    );
}


// ************************************************************************* //
