// SPDX-License-Identifier: GPL-3.0-or-later

#include "givenLoads.H"
#include "dictionaryCheck.H"
#include "nodesInRegion.H"
#include "readFunction.H"
#include "rigidTurn.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace fsi
{

//- Add forces of the rigid rotation that a torque sets off in one copy, whose
//  nodes have these masses and places relative to the centre of mass
static void addTorque
(
    const Eigen::Map<const Eigen::VectorXd>& masses,
    const Eigen::Ref<const Eigen::MatrixXd>& fromCentre,
    const vector& torque,
    Eigen::Ref<Eigen::MatrixXd> force
)
{
    const Eigen::Index nDims = fromCentre.cols();
    Eigen::MatrixXd r(Eigen::MatrixXd::Zero(fromCentre.rows(), 3));
    r.leftCols(nDims) = fromCentre;
    Eigen::Vector3d axis(0, 0, torque.z());
    if (nDims == 3)
    {
        axis = Eigen::Vector3d(torque.x(), torque.y(), torque.z());
    }
    const Eigen::Matrix3d S(r.transpose()*masses.asDiagonal()*r);
    const Eigen::Matrix3d cross(crossMatrix(angularVelocityOf(S, axis)));
    force += masses.asDiagonal()*(r*cross.transpose()).leftCols(nDims);
}

} // End namespace fsi
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::givenLoads::givenLoads(const population& bodies)
:
    forces_(bodies.groups().size()),
    torques_(bodies.groups().size()),
    loads_(bodies.groups().size()),
    pulls_(bodies.groups().size()),
    pulled_(bodies.groups().size())
{
    forAll(bodies.groups(), groupi)
    {
        const dictionary& motion = bodies.motion(groupi);
        if (!bodies.groups()[groupi].movesFreely())
        {
            continue;
        }
        if (motion.found("force"))
        {
            forces_.set(groupi, readFunction<vector>(motion, "force"));
        }
        if (motion.found("torque"))
        {
            torques_.set(groupi, readFunction<vector>(motion, "torque"));
        }
        loads_[groupi] =
            objectLoad::newLoads(motion.subOrEmptyDict("loads"));
        readPulls
        (
            groupi,
            bodies.groups()[groupi].shape(),
            motion.subOrEmptyDict("pulls")
        );
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::fsi::givenLoads::readPulls
(
    const label groupi,
    const shapeTemplate& shape,
    const dictionary& dict
)
{
    PtrList<Function1<vector>>& forces = pulls_[groupi];
    forces.setSize(dict.size());
    pulled_[groupi].setSize(dict.size());
    label pulli = 0;
    for (const entry& e : dict)
    {
        const dictionary& region = dictOf(dict, e, "region");
        pulled_[groupi][pulli] = nodesInRegion
        (
            region, shape.mesh().points, shape.nDims(), {"force"}
        );
        forces.set(pulli, readFunction<vector>(region, "force"));
        ++pulli;
    }
}


void Foam::fsi::givenLoads::addToCopies
(
    const Time& time,
    const label groupi,
    const bodyGroup& group,
    Eigen::MatrixXd& force
) const
{
    const PtrList<objectLoad>& loads = loads_[groupi];
    if (loads.empty() && !torques_.set(groupi))
    {
        return;
    }
    const shapeTemplate& shape = group.shape();
    const Eigen::Map<const Eigen::VectorXd> masses
    (
        shape.nodeMasses().cdata(), shape.nNodes()
    );
    const label nDims = shape.nDims();
    for (label copyi = 0; copyi < group.size(); ++copyi)
    {
        const auto x = group.positions().middleCols(nDims*copyi, nDims);
        const Eigen::RowVectorXd centre(masses.transpose()*x/masses.sum());
        objectLoad::load sum;
        if (torques_.set(groupi))
        {
            sum.torque = torques_[groupi].value(time.value());
        }
        objectLoad::state object
        {
            group.objectIds()[copyi], shape.mass(), Zero,
            group.velocity(copyi), group.angularVelocity(copyi)
        };
        for (label d = 0; d < nDims; ++d)
        {
            object.centre[direction(d)] = centre[d];
        }
        for (const objectLoad& each : loads)
        {
            each.add(object, time, sum);
        }
        auto nodal = force.middleCols(nDims*copyi, nDims);
        for (label d = 0; d < nDims; ++d)
        {
            nodal.col(d) += masses*(sum.force[direction(d)]/masses.sum());
        }
        addTorque(masses, x.rowwise() - centre, sum.torque, nodal);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::givenLoads::add
(
    const Time& time,
    const label groupi,
    const bodyGroup& group,
    const vector& acceleration,
    Eigen::MatrixXd& force
) const
{
    const Eigen::Map<const Eigen::VectorXd> masses
    (
        group.shape().nodeMasses().cdata(), group.shape().nNodes()
    );
    const label nDims = group.shape().nDims();
    vector a(acceleration);
    if (forces_.set(groupi))
    {
        a += forces_[groupi].value(time.value())/group.mass();
    }
    for (Eigen::Index column = 0; column < force.cols(); ++column)
    {
        force.col(column) += masses*a[direction(column % nDims)];
    }
    addToCopies(time, groupi, group, force);
    forAll(pulls_[groupi], pulli)
    {
        const labelList& nodes = pulled_[groupi][pulli];
        const vector each
        (
            pulls_[groupi][pulli].value(time.value())/nodes.size()
        );
        for (Eigen::Index column = 0; column < force.cols(); ++column)
        {
            for (const label nodei : nodes)
            {
                force(nodei, column) += each[direction(column % nDims)];
            }
        }
    }
}


// ************************************************************************* //
