// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyCopies.H"
#include "boolList.H"
#include "groupEntries.H"
#include "matrixEntry.H"
#include "openfoamVersion.H"

#include <algorithm>

// * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * * //

void Foam::fsi::bodyCopies::startCopy
(
    const label copyi,
    const label objectId
)
{
    objectIds_[copyi] = objectId;
    ofCopy(owedImpulse_, copyi).setZero();
    contactRange_.col(copyi).setZero();
    ofCopy(contactForce_, copyi).setZero();
    periods_.col(copyi).setZero();
}


void Foam::fsi::bodyCopies::setAnchors(const label copyi)
{
    const labelList& held = shape_.held().nodes();
    for (label k = 0; k < held.size(); ++k)
    {
        ofCopy(anchors_, copyi).row(k) =
            ofCopy(positions(), copyi).row(held[k]);
    }
}


void Foam::fsi::bodyCopies::writeCopies(Ostream& os) const
{
    putEntry(os, "shape", shape_.name());
    putList(os, "objectIds", objectIds_);
    writeNodes(os);
    writeMatrix(os, "owedImpulse", owedImpulse_);
    writeMatrix(os, "contactRange", contactRange_);
    if (!contactForce_.isZero(0))
    {
        writeMatrix(os, "contactForce", contactForce_);
    }
    writeMatrix(os, "periods", periods_);
    if (anchors_.rows())
    {
        writeMatrix(os, "anchors", anchors_);
    }
}


void Foam::fsi::bodyCopies::readCopies(const dictionary& dict)
{
    const labelList ids(readGroupIds(dict, shape_.name()));
    resize(ids.size());
    objectIds_ = ids;
    readNodes(dict);
    readMatrix(dict, "owedImpulse", owedImpulse_);
    readMatrix(dict, "contactRange", contactRange_);
    contactForce_.setZero();
    if (dict.found("contactForce"))
    {
        readMatrix(dict, "contactForce", contactForce_);
    }
    readMatrix(dict, "periods", periods_);
    if (anchors_.rows())
    {
        readMatrix(dict, "anchors", anchors_);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsi::bodyCopies::bodyCopies(const shapeTemplate& shape)
:
    shape_(shape)
{
    resizeNodes(shape.nNodes(), 0);
    owedImpulse_.resize(shape.nBoundaryNodes(), 0);
    contactRange_.resize(1, 0);
    contactForce_.resize(shape.nBoundaryNodes(), 0);
    periods_.resize(3, 0);
    anchors_.resize(shape.held().nodes().size(), 0);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::fsi::bodyCopies::resize(const label nCopies)
{
    resizeNodes(shape_.nNodes(), shape_.nDims()*nCopies);
    objectIds_.resize(nCopies, -1);
    const label nColumns = shape_.nDims()*nCopies;
    owedImpulse_.conservativeResize(shape_.nBoundaryNodes(), nColumns);
    contactRange_.conservativeResize(1, nCopies);
    contactForce_.conservativeResize(shape_.nBoundaryNodes(), nColumns);
    periods_.conservativeResize(3, nCopies);
    anchors_.conservativeResize(anchors_.rows(), nColumns);
    resizeState(nCopies);
}


void Foam::fsi::bodyCopies::remove(const labelUList& copies)
{
    boolList stays(size(), true);
    for (const label copyi : copies)
    {
        stays[copyi] = false;
    }
    label next = 0;
    forAll(stays, copyi)
    {
        if (stays[copyi] && next < copyi)
        {
            copyValues taken;
            exchange(copyi, taken);
            copyValues given(taken.values());
            exchange(next, given);
        }
        next += stays[copyi];
    }
    resize(next);
}


void Foam::fsi::bodyCopies::exchange(const label copyi, copyValues& values)
{
    const label nDims = shape_.nDims();
    values.number(objectIds_[copyi]);
    exchangeNodes(nDims*copyi, nDims, values);
    values.block(ofCopy(owedImpulse_, copyi));
    values.block(contactRange_.col(copyi));
    values.block(ofCopy(contactForce_, copyi));
    values.block(periods_.col(copyi));
    values.block(ofCopy(anchors_, copyi));
    exchangeState(copyi, values);
}


void Foam::fsi::bodyCopies::sort()
{
    if (std::is_sorted(objectIds_.begin(), objectIds_.end()))
    {
        return;
    }
    labelList order(identityList(size()));
    std::sort(order.begin(), order.end(), [&](const label a, const label b)
    {
        return objectIds_[a] < objectIds_[b];
    });
    copyValues taken;
    for (const label copyi : order)
    {
        take(copyi, taken);
    }
    copyValues given(taken.values());
    for (label copyi = 0; copyi < size(); ++copyi)
    {
        exchange(copyi, given);
    }
}


void Foam::fsi::bodyCopies::moveBack
(
    const label copyi,
    const labelVector& n,
    const vector& period
)
{
    for (direction d = 0; d < shape_.nDims(); ++d)
    {
        positions().col(shape_.nDims()*copyi + d).array() -= n[d]*period[d];
        anchors_.col(shape_.nDims()*copyi + d).array() -= n[d]*period[d];
        periods_(d, copyi) += n[d];
    }
}


// ************************************************************************* //
